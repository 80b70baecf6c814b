// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// KnownMap, locate and Localizer: scans found in a map.
#include <fmt/core.h>
#include <pybind11/stl.h>

#include <memory>

#include "python/src/bindings.hpp"
#include "python/src/conversions.hpp"
#include "python/src/guarded.hpp"
#include "python/src/maps.hpp"
#include "python/src/scans.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/localisation/known_map.hpp"
#include "setsquare/localisation/localizer.hpp"
#include "setsquare/pipeline/localize_log.hpp"

namespace py = pybind11;

namespace setsquare::python {
namespace {

/// Shared by localizers of several threads: never changed.
using PyKnownMap = std::shared_ptr<KnownMap>;

PyKnownMap known_map_from(const py::object& map) {
  if (py::isinstance<OccupancyGrid>(map)) {
    const auto& grid = map.cast<const OccupancyGrid&>();
    return without_gil([&] { return std::make_shared<KnownMap>(grid); });
  }
  if (py::isinstance<PyMap>(map)) {
    const auto& mapped = map.cast<const PyMap&>();
    return without_gil([&] { return std::make_shared<KnownMap>(mapped.map()); });
  }
  const std::string path = path_from(map);
  // pybind11 holds nothing that is const; nothing of a KnownMap can be changed anyway.
  return without_gil(
      [&] { return std::const_pointer_cast<KnownMap>(read_map_to_localise_in(path).known); });
}

using PyLocalizer = Guarded<Localizer>;

void bind_places(py::module_& module) {
  py::class_<PossiblePlace>(module, "PossiblePlace", "A place where a scan may have been taken.")
      .def_readonly("T_map_sensor", &PossiblePlace::T_map_sensor, "Of the sensor there.")
      .def_readonly("probability", &PossiblePlace::probability, "That it was taken there.")
      .def_property_readonly(
          "covariance",
          [](const PossiblePlace& place) { return array_of<3, 3>(place.covariance); },
          "Of (x, y, theta) in the map frame, shape (3, 3), if it is this place.")
      .def("__repr__", [](const PossiblePlace& place) {
        return fmt::format("PossiblePlace(x {:.3f} m, y {:.3f} m, theta {:.4f} rad, {:.3f})",
                           place.T_map_sensor.x_m,
                           place.T_map_sensor.y_m,
                           place.T_map_sensor.theta_rad,
                           place.probability);
      });
  py::class_<LocatedScan>(module, "LocatedScan", "Where a scan was taken.")
      .def_property_readonly(
          "status",
          [](const LocatedScan& located) { return std::string(to_string(located.status)); },
          R"("localised", "ambiguous" or "lost".)")
      .def_readonly("places",
                    &LocatedScan::places,
                    "The most probable first; what their probabilities leave is \"elsewhere\".")
      .def("__repr__", [](const LocatedScan& located) {
        return fmt::format(
            "LocatedScan({}, {} places)", to_string(located.status), located.places.size());
      });
  py::class_<LocalisedPose>(module, "LocalisedPose", "Where the robot is at one scan.")
      .def_property_readonly(
          "stamp_ns", [](const LocalisedPose& pose) { return pose.stamp.ns; }, "Of the scan.")
      .def_property_readonly(
          "status",
          [](const LocalisedPose& pose) { return std::string(to_string(pose.status)); },
          R"("localised", "ambiguous" or "lost".)")
      .def_readonly("T_map_sensor", &LocalisedPose::T_map_sensor, "Of the most probable place.")
      .def_readonly(
          "T_map_base", &LocalisedPose::T_map_base, "The robot's, by the scan's mounting.")
      .def_readonly("probability", &LocalisedPose::probability, "Of that place.")
      .def_property_readonly(
          "covariance",
          [](const LocalisedPose& pose) { return array_of<3, 3>(pose.covariance); },
          "Of (x, y, theta) of the sensor in the map frame, shape (3, 3), if it is that place.")
      .def_readonly("is_confirmed",
                    &LocalisedPose::is_confirmed,
                    "Whether the scan was compared with the map there, and agrees.")
      .def_readonly("unconfirmed_m", &LocalisedPose::unconfirmed_m, "Driven since a scan was.")
      .def_readonly("alternatives", &LocalisedPose::alternatives, "Other PossiblePlaces.")
      .def("__repr__", [](const LocalisedPose& pose) {
        return fmt::format("LocalisedPose({}, x {:.3f} m, y {:.3f} m, theta {:.4f} rad, {:.3f})",
                           to_string(pose.status),
                           pose.T_map_base.x_m,
                           pose.T_map_base.y_m,
                           pose.T_map_base.theta_rad,
                           pose.probability);
      });
}

void bind_localizer(py::module_& module) {
  py::class_<PyLocalizer>(module, "Localizer", R"(Finds a robot in a map and follows it.

    localizer = Localizer(KnownMap("out"))
    for record in read_log("today.clf"):
        pose = localizer.add(record.scan, record.T_odom_base)

Nothing need be known of its start. Threads may share a localizer: they take turns.)")
      .def(py::init(
               [](const PyKnownMap& map) { return std::make_unique<PyLocalizer>(Localizer(map)); }),
           py::arg("map"))
      .def(
          "add",
          [](PyLocalizer& self,
             const py::object& scan,
             const std::optional<Pose2>& T_odom_base,
             const std::optional<double>& fov_deg) {
            const auto added = scan_from(scan, fov_deg);
            return self.with(
                [&](Localizer& localizer) { return localizer.add(*added, T_odom_base); });
          },
          py::arg("scan"),
          py::arg("T_odom_base") = py::none(),
          py::kw_only(),
          py::arg("fov_deg") = py::none(),
          R"(The next scan, with the robot's pose by wheel odometry where there is one.

scan: a Scan, or an array of ranges (N,) in m over fov_deg degrees (180). Returns a LocalisedPose.
Raises ParameterError where the scan's geometry is not valid or a pose is not finite.)")
      .def(
          "set_pose",
          [](PyLocalizer& self, const Pose2& T_map_base) {
            self.with([&](Localizer& localizer) { localizer.set_pose(T_map_base); });
          },
          py::arg("T_map_base"),
          "Says where the robot is at the next scan, to about 1 m and 30 deg.");
}

}  // namespace

void bind_localisation(py::module_& module) {
  bind_places(module);
  py::class_<KnownMap, PyKnownMap>(module, "KnownMap", R"(A map made ready to find scans in it.

map: an OccupancyGrid, a Map, or a path: a folder that Map.save or `setsquare map` wrote, or the
map.yaml of any program (nav2). A Map's own scans, also those of a folder, tell places apart that are
alike in a grid. Made once, shared by any number of threads. Raises FileError, FormatError.)")
      .def(py::init(&known_map_from), py::arg("map"))
      .def_property_readonly(
          "is_empty", &KnownMap::is_empty, "Whether it has no walls or no space.");
  bind_localizer(module);
  module.def(
      "locate",
      [](const PyKnownMap& map, const py::object& scan, const std::optional<double>& fov_deg) {
        const auto sought = scan_from(scan, fov_deg);
        return without_gil([&] { return locate_scan(*map, *sought); });
      },
      py::arg("map"),
      py::arg("scan"),
      py::kw_only(),
      py::arg("fov_deg") = py::none(),
      R"(Where in a map a scan was taken, of which nothing is known: the whole map is searched.

scan: a Scan, or an array of ranges (N,) in m over fov_deg degrees (180). Returns a LocatedScan.
Raises ParameterError where the scan's geometry is not valid.)");
}

}  // namespace setsquare::python
