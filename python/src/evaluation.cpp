// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Errors against the truth.
#include <fmt/core.h>
#include <pybind11/stl.h>

#include "python/src/bindings.hpp"
#include "python/src/conversions.hpp"
#include "python/src/trajectories.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/eval/evaluate.hpp"
#include "setsquare/io/tables/relations.hpp"

namespace py = pybind11;

namespace setsquare::python {
namespace {

/// None for 0 resamples.
std::optional<BootstrapParams> bootstrap_of(std::size_t num_resamples) {
  if (num_resamples == 0) return std::nullopt;
  return BootstrapParams{.num_resamples = num_resamples};
}

py::tuple pair_of(const ErrorBound& bound) { return py::make_tuple(bound.low, bound.high); }

/// A bound as (low, high).
auto bound_at(ErrorBound ErrorBounds::*bound) {
  return [bound](const ErrorBounds& self) { return pair_of(self.*bound); };
}

void bind_bounds(py::module_& module) {
  py::class_<ErrorBounds>(
      module, "ErrorBounds", R"(5 and 95 % of statistics: (low, high), in their unit.

By a block bootstrap: errors are drawn in blocks of neighbours, for those are alike.)")
      .def_property_readonly("mean", bound_at(&ErrorBounds::mean), "Of the mean.")
      .def_property_readonly("rmse", bound_at(&ErrorBounds::rmse), "Of the root mean square.")
      .def_property_readonly("median", bound_at(&ErrorBounds::median), "Of the median.")
      .def_property_readonly(
          "deviation", bound_at(&ErrorBounds::deviation), "Of the standard deviation.")
      .def_readonly("block_length", &ErrorBounds::block_length, "Errors that were drawn together.")
      .def("__repr__", [](const ErrorBounds& self) {
        return fmt::format("ErrorBounds(mean={:.6g} to {:.6g}, rmse={:.6g} to {:.6g})",
                           self.mean.low,
                           self.mean.high,
                           self.rmse.low,
                           self.rmse.high);
      });
}

void bind_statistics(py::module_& module) {
  bind_bounds(module);
  py::class_<ErrorStatistics>(
      module, "ErrorStatistics", "Summary of a set of errors, in their unit; as evo's.")
      .def_readonly("num_values", &ErrorStatistics::num_values, "How many errors there were.")
      .def_readonly("mean", &ErrorStatistics::mean, "Their mean.")
      .def_readonly("rmse", &ErrorStatistics::rmse, "Root of the mean of their squares.")
      .def_readonly("median", &ErrorStatistics::median, "Of two in the middle the mean.")
      .def_readonly("max", &ErrorStatistics::max, "The largest.")
      .def_readonly("deviation",
                    &ErrorStatistics::deviation,
                    "Standard deviation about the mean, divided by n.")
      .def_readonly("bounds", &ErrorStatistics::bounds, "None where they were not asked for.")
      .def("__repr__", [](const ErrorStatistics& self) {
        return fmt::format("ErrorStatistics(mean={:.6g}, rmse={:.6g}, max={:.6g}, num_values={})",
                           self.mean,
                           self.rmse,
                           self.max,
                           self.num_values);
      });
  py::class_<MeanAndDeviation>(module, "MeanAndDeviation", "Mean and sample standard deviation.")
      .def_readonly("mean", &MeanAndDeviation::mean, "Of the errors, in their unit.")
      .def_readonly("deviation",
                    &MeanAndDeviation::deviation,
                    "Sample standard deviation (n - 1), in the same unit.")
      .def_property_readonly(
          "mean_bound",
          [](const MeanAndDeviation& self) -> py::object {
            if (!self.mean_bound) return py::none();
            return pair_of(*self.mean_bound);
          },
          "5 and 95 % of the mean: (low, high); None where it was not asked for.")
      .def("__repr__", [](const MeanAndDeviation& self) {
        return fmt::format(
            "MeanAndDeviation(mean={:.6g}, deviation={:.6g})", self.mean, self.deviation);
      });
}

void bind_absolute(py::module_& module) {
  py::class_<AbsoluteTrajectoryError>(
      module, "AbsoluteTrajectoryError", "ATE (Sturm et al. 2012) after the best rigid alignment.")
      .def_readonly("T_truth_map", &AbsoluteTrajectoryError::T_truth_map, "The alignment.")
      .def_readonly(
          "translation_m", &AbsoluteTrajectoryError::translation_m, "Of the positions, in m.")
      .def_readonly(
          "rotation_rad", &AbsoluteTrajectoryError::rotation_rad, "Of the headings, in rad.")
      .def_readonly("final_translation_m",
                    &AbsoluteTrajectoryError::final_translation_m,
                    "Of the last pose, in m.")
      .def_readonly("final_rotation_rad",
                    &AbsoluteTrajectoryError::final_rotation_rad,
                    "Of the last pose, in rad.")
      .def("__repr__", [](const AbsoluteTrajectoryError& self) {
        return fmt::format("AbsoluteTrajectoryError(rmse {:.4f} m, {:.3f} deg; {} poses)",
                           self.translation_m.rmse,
                           deg_from_rad(self.rotation_rad.rmse),
                           self.translation_m.num_values);
      });
  module.def(
      "evaluate_trajectory",
      [](const TrajectoryArrays& trajectory,
         const TrajectoryArrays& truth,
         std::size_t num_resamples) {
        return evaluate(trajectory.poses, truth.poses, bootstrap_of(num_resamples));
      },
      py::arg("trajectory"),
      py::arg("truth"),
      py::kw_only(),
      py::arg("num_resamples") = 0,
      R"(The absolute error of a trajectory (m, rad) against the true one.

Poses are paired by their stamps, within 12 microseconds.
num_resamples: for bounds of the statistics (ErrorStatistics.bounds), 20 or more; 0: none. They are
    those of `setsquare evaluate ate --bootstrap`.

Raises ParameterError where no pose pairs.)");
}

void bind_relations(py::module_& module) {
  py::class_<RelationErrors>(module, "RelationErrors", "Errors of a set of relations.")
      .def_readonly("num_relations", &RelationErrors::num_relations, "That were compared.")
      .def_readonly("translation_m", &RelationErrors::translation_m, "Of the positions, in m.")
      .def_readonly("rotation_rad", &RelationErrors::rotation_rad, "Of the headings, in rad.")
      .def("__repr__", [](const RelationErrors& self) {
        return fmt::format("RelationErrors({:.4f} m, {:.3f} deg; {} relations)",
                           self.translation_m.mean,
                           deg_from_rad(self.rotation_rad.mean),
                           self.num_relations);
      });
  py::class_<RelationErrorReport>(module, "RelationErrorReport", "By the time between the poses.")
      .def_readonly(
          "all", &RelationErrorReport::all, "Of every relation both of whose stamps have a pose.")
      .def_readonly("under_60_s",
                    &RelationErrorReport::under_60_s,
                    "Of those with less than 60 s between their stamps: how well neighbours fit.")
      .def_readonly("from_60_s",
                    &RelationErrorReport::from_60_s,
                    "Of those with 60 s and more: how well the map closes.")
      .def_readonly("num_missing",
                    &RelationErrorReport::num_missing,
                    "Relations with a stamp that the trajectory does not have.")
      .def("__repr__", [](const RelationErrorReport& self) {
        return fmt::format("RelationErrorReport({:.4f} m, {:.3f} deg; {} relations)",
                           self.all.translation_m.mean,
                           deg_from_rad(self.all.rotation_rad.mean),
                           self.all.num_relations);
      });
  module.def(
      "evaluate_relations",
      [](const TrajectoryArrays& trajectory, const py::object& path, std::size_t num_resamples) {
        return evaluate(
            trajectory.poses, read_relations(path_from(path)), bootstrap_of(num_resamples));
      },
      py::arg("trajectory"),
      py::arg("path"),
      py::kw_only(),
      py::arg("num_resamples") = 0,
      R"(The error by relations between poses (m, rad; Kuemmerle et al. 2009).

path: a file of the true relations, a line each: stamp1 stamp2 x y z roll pitch yaw.
num_resamples: for bounds of the means (mean_bound), 20 or more; 0: none.
Raises FileError, FormatError.)");
}

}  // namespace

void bind_evaluation(py::module_& module) {
  bind_statistics(module);
  bind_absolute(module);
  bind_relations(module);
}

}  // namespace setsquare::python
