// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Scan: ranges in, arrays out.
#include "python/src/scans.hpp"

#include <fmt/core.h>
#include <pybind11/stl.h>

#include <limits>
#include <memory>

#include "python/src/bindings.hpp"
#include "python/src/conversions.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/scan/scan.hpp"
#include "setsquare/scan/scan_to_points.hpp"
#include "setsquare/scan/symmetric_bearings.hpp"

namespace py = pybind11;

namespace setsquare::python {
namespace {

/// What a scan is made of, besides its ranges.
struct ScanGeometry {
  std::optional<double> fov_deg;
  std::optional<double> first_bearing_rad;
  std::optional<double> bearing_step_rad;
};

void set_bearings(Scan& scan, const ScanGeometry& geometry) {
  if (geometry.first_bearing_rad || geometry.bearing_step_rad) {
    if (!geometry.first_bearing_rad || !geometry.bearing_step_rad || geometry.fov_deg) {
      throw ParameterError("fov_deg",
                           "give it alone, or both first_bearing_rad and bearing_step_rad");
    }
    scan.first_bearing_rad = *geometry.first_bearing_rad;
    scan.bearing_step_rad = *geometry.bearing_step_rad;
    return;
  }
  const double fov_deg = geometry.fov_deg.value_or(180.0);
  if (!(fov_deg > 0.0 && fov_deg <= 360.0)) {
    throw ParameterError("fov_deg", "must be above 0 and at most 360");
  }
  const double fov_rad = rad_from_deg(fov_deg);
  scan.first_bearing_rad = -0.5 * fov_rad;
  scan.bearing_step_rad = symmetric_step_rad(fov_rad, scan.num_beams());
}

std::shared_ptr<Scan> scan_from_ranges(const DoubleArray& ranges_m, const ScanGeometry& geometry) {
  if (ranges_m.ndim() != 1) throw ParameterError("ranges_m", "must have the shape (N,)");
  auto scan = std::make_shared<Scan>();
  scan->ranges_m.assign(ranges_m.data(), ranges_m.data() + ranges_m.size());
  set_bearings(*scan, geometry);
  return scan;
}

/// Cartesian points of the returns, shape (N, 2), in the sensor frame.
DoubleArray points_of(const Scan& scan) {
  const PointSet points = points_from_scan(scan);
  DoubleArray array({static_cast<py::ssize_t>(points.size()), py::ssize_t{2}});
  double* to = array.mutable_data();
  for (std::size_t i = 0; i < points.size(); ++i) {
    *to++ = points.x_m[i];
    *to++ = points.y_m[i];
  }
  return array;
}

DoubleArray bearings_of(const Scan& scan) {
  DoubleArray bearings(static_cast<py::ssize_t>(scan.num_beams()));
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    bearings.mutable_at(static_cast<py::ssize_t>(beam)) = scan.bearing_rad(beam);
  }
  return bearings;
}

/// All that a scan is, for pickle and copy.
py::tuple state_of(const Scan& scan) {
  DoubleArray ranges_m(static_cast<py::ssize_t>(scan.num_beams()));
  std::copy(scan.ranges_m.begin(), scan.ranges_m.end(), ranges_m.mutable_data());
  return py::make_tuple(ranges_m,
                        scan.first_bearing_rad,
                        scan.bearing_step_rad,
                        scan.min_range_m,
                        scan.max_range_m,
                        scan.T_base_sensor,
                        scan.stamp.ns,
                        scan.time_increment_s,
                        scan.scan_time_s,
                        scan.scanner);
}

std::shared_ptr<Scan> scan_from_state(const py::tuple& state) {
  const auto ranges_m = state[0].cast<DoubleArray>();
  auto scan = std::make_shared<Scan>();
  scan->ranges_m.assign(ranges_m.data(), ranges_m.data() + ranges_m.size());
  scan->first_bearing_rad = state[1].cast<double>();
  scan->bearing_step_rad = state[2].cast<double>();
  scan->min_range_m = state[3].cast<double>();
  scan->max_range_m = state[4].cast<double>();
  scan->T_base_sensor = state[5].cast<Pose2>();
  scan->stamp.ns = state[6].cast<std::int64_t>();
  scan->time_increment_s = state[7].cast<double>();
  scan->scan_time_s = state[8].cast<double>();
  scan->scanner = state[9].cast<std::uint32_t>();
  scan->validate();
  return scan;
}

constexpr auto kScanDoc = R"(One sweep of a laser scanner.

ranges_m: float array of shape (N,), in m, as the sensor gave them; NaN, zeros and codes are welcome.
fov_deg: angle of the whole sweep, symmetric about straight ahead, counterclockwise (default 180);
    the step is fov / N for an even number of beams, fov / (N - 1) for an odd one. Or give
first_bearing_rad and bearing_step_rad: of beam 0, and from a beam to the next; x forward, y left.
min_range_m, max_range_m: ranges below are no measurements, at or above no returns.
T_base_sensor: the sensor's mounting on the robot, a Pose2 or (x_m, y_m, theta_rad).
stamp_s or, exactly, stamp_ns: time of the first beam.
time_increment_s, scan_time_s: from beam to beam, from sweep to sweep; 0 where unknown.
scanner: a number for each of the robot's scanners.

Raises ParameterError where the geometry is invalid.)";

}  // namespace

std::shared_ptr<const Scan> scan_from(const py::object& object,
                                      const std::optional<double>& fov_deg) {
  if (py::isinstance<Scan>(object)) {
    if (fov_deg) throw ParameterError("fov_deg", "is for arrays of ranges; a Scan has its angles");
    return object.cast<std::shared_ptr<Scan>>();
  }
  const auto scan =
      scan_from_ranges(object.cast<DoubleArray>(), {fov_deg, std::nullopt, std::nullopt});
  scan->validate();
  return scan;
}

void bind_scans(py::module_& module) {
  py::class_<Scan, std::shared_ptr<Scan>>(module, "Scan", kScanDoc)
      .def(py::init([](const DoubleArray& ranges_m,
                       std::optional<double> fov_deg,
                       std::optional<double> first_bearing_rad,
                       std::optional<double> bearing_step_rad,
                       double min_range_m,
                       double max_range_m,
                       const Pose2& T_base_sensor,
                       double stamp_s,
                       std::optional<std::int64_t> stamp_ns,
                       double time_increment_s,
                       double scan_time_s,
                       std::uint32_t scanner) {
             const auto scan =
                 scan_from_ranges(ranges_m, {fov_deg, first_bearing_rad, bearing_step_rad});
             scan->min_range_m = min_range_m;
             scan->max_range_m = max_range_m;
             scan->T_base_sensor = T_base_sensor;
             scan->stamp = stamp_from(stamp_s, stamp_ns);
             scan->time_increment_s = time_increment_s;
             scan->scan_time_s = scan_time_s;
             scan->scanner = scanner;
             scan->validate();
             return scan;
           }),
           py::arg("ranges_m"),
           py::kw_only(),
           py::arg("fov_deg") = py::none(),
           py::arg("first_bearing_rad") = py::none(),
           py::arg("bearing_step_rad") = py::none(),
           py::arg("min_range_m") = 0.0,
           py::arg("max_range_m") = std::numeric_limits<double>::infinity(),
           py::arg("T_base_sensor") = Pose2{},
           py::arg("stamp_s") = 0.0,
           py::arg("stamp_ns") = py::none(),
           py::arg("time_increment_s") = 0.0,
           py::arg("scan_time_s") = 0.0,
           py::arg("scanner") = 0)
      .def_property_readonly(
          "ranges_m",
          [](const py::object& self) { return view_of(self.cast<const Scan&>().ranges_m, self); },
          "float array of shape (N,), in m, read-only: the scan's own memory, not a copy.")
      .def_property_readonly("bearings_rad", &bearings_of, "float array of shape (N,), in rad.")
      .def("points",
           &points_of,
           "Returns of the sweep in the sensor frame: float array of shape (M, 2), in m.")
      .def_readonly("first_bearing_rad",
                    &Scan::first_bearing_rad,
                    "Bearing of beam 0: 0 ahead, counterclockwise.")
      .def_readonly("bearing_step_rad",
                    &Scan::bearing_step_rad,
                    "From a beam to the next; negative where the sensor turns clockwise.")
      .def_readonly("min_range_m", &Scan::min_range_m, "Ranges below it are no measurements.")
      .def_readonly("max_range_m", &Scan::max_range_m, "Ranges at or above it are no-returns.")
      .def_readonly("T_base_sensor", &Scan::T_base_sensor, "The sensor's mounting on the robot.")
      .def_readonly("time_increment_s",
                    &Scan::time_increment_s,
                    "From a beam to the next; 0 where it is not known.")
      .def_readonly(
          "scan_time_s", &Scan::scan_time_s, "From a sweep to the next; 0 where it is not known.")
      .def_readonly(
          "scanner", &Scan::scanner, "Which of the robot's scanners: another number for each.")
      .def_property_readonly(
          "stamp_ns", [](const Scan& scan) { return scan.stamp.ns; }, "Time of the first beam, ns.")
      .def_property_readonly(
          "stamp_s",
          [](const Scan& scan) { return scan.stamp.seconds(); },
          "The same in seconds; rounded to what a double holds.")
      .def(py::pickle(&state_of, &scan_from_state))
      .def("__len__", &Scan::num_beams)
      .def("__repr__", [](const Scan& scan) {
        return fmt::format("Scan({} beams, {:.1f} deg, stamp_s={})",
                           scan.num_beams(),
                           deg_from_rad(scan.field_of_view_rad()),
                           to_string(scan.stamp));
      });
}

}  // namespace setsquare::python
