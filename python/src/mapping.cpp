// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Mapper, scan by scan, and map_log, a whole log in one call.
#include <fmt/core.h>
#include <pybind11/stl.h>

#include <chrono>
#include <functional>
#include <memory>

#include "python/src/bindings.hpp"
#include "python/src/conversions.hpp"
#include "python/src/guarded.hpp"
#include "python/src/log_options.hpp"
#include "python/src/maps.hpp"
#include "python/src/scans.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/pipeline/map_log.hpp"
#include "setsquare/pipeline/merge_maps.hpp"

namespace py = pybind11;

namespace setsquare::python {
namespace {

/// Lets Ctrl-C end long work, and tells `progress`, if any, how far it is; both need Python's
/// interpreter, so that they happen a few times a second and not for each scan.
class Watch {
 public:
  explicit Watch(py::object progress) : progress_(std::move(progress)) {}

  void operator()(std::optional<double> fraction) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    const py::gil_scoped_acquire acquire;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!progress_.is_none()) progress_(fraction);
  }

 private:
  py::object progress_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

PyMap map_log_of(const py::object& path,
                 bool odometry,
                 bool audit,
                 const std::string& preset,
                 const PyMap* continue_from,
                 int num_threads,
                 const py::object& progress,
                 const py::kwargs& log_options) {
  MapLogOptions options;
  options.log = log_options_from(log_options);
  options.uses_odometry = odometry;
  options.is_audited = audit;
  options.num_threads = static_cast<std::size_t>(threads_from(num_threads));
  options.preset = preset_from(preset);
  if (continue_from != nullptr) {
    options.known_map = {continue_from->saved, &continue_from->saved->map};
    options.known_map_name = continue_from->saved->record.run.log;
  }
  const std::vector<std::string> paths = paths_from(path);
  Watch watch(progress);
  return PyMap(without_gil(
      [&] { return map_logs(paths, options, {.on_progress = std::ref(watch), .on_stage = {}}); }));
}

using PyMapper = Guarded<Mapper>;

std::unique_ptr<PyMapper> mapper_from(const PyMap* continue_from, bool audit, int num_threads) {
  MapperParams params;
  params.audit.is_on = audit;
  params.num_threads = static_cast<std::size_t>(threads_from(num_threads));
  if (continue_from == nullptr) return std::make_unique<PyMapper>(Mapper(params));
  const auto saved = continue_from->saved;
  return std::make_unique<PyMapper>(without_gil([&] { return Mapper(saved->map, params); }));
}

PyMap merged_map_of(const std::vector<PyMap>& maps, int num_threads) {
  std::vector<SavedMap> saved;
  std::vector<std::string> names;
  for (const PyMap& map : maps) {
    saved.push_back(*map.saved);
    names.push_back("maps[" + std::to_string(names.size()) + "]");
  }
  const auto threads = static_cast<std::size_t>(threads_from(num_threads));
  return PyMap(without_gil([&] { return merge_maps(saved, names, threads); }));
}

void bind_tracked_pose(py::module_& module) {
  py::class_<TrackedPose>(module, "TrackedPose", "A scan placed by tracking; provisional.")
      .def_property_readonly(
          "status",
          [](const TrackedPose& self) { return std::string(to_string(self.status)); },
          R"("tracked", "degenerate", "recovered" or "lost".)")
      .def_readonly(
          "T_odom_sensor",
          &TrackedPose::T_odom_sensor,
          "Pose of its sensor at the middle of its sweep, in the odom frame: smooth, drifts.")
      .def_readonly("is_keyframe", &TrackedPose::is_keyframe, "Whether it is kept to match with.")
      .def_readonly("is_mapped",
                    &TrackedPose::is_mapped,
                    "Else the pose is the expected one: its scanner's mounting is not confirmed.")
      .def_readonly("score",
                    &TrackedPose::score,
                    "Share of the points explained by the submap less share contradicted.")
      .def("__repr__", [](const TrackedPose& self) {
        return fmt::format("TrackedPose({}, x {:.3f} m, y {:.3f} m, theta {:.4f} rad)",
                           to_string(self.status),
                           self.T_odom_sensor.x_m,
                           self.T_odom_sensor.y_m,
                           self.T_odom_sensor.theta_rad);
      });
}

void bind_mapper(py::module_& module) {
  py::class_<PyMapper>(module, "Mapper", R"(Scans in, map out.

    mapper = Mapper()
    for record in read_log("intel.clf"):
        mapper.add(record.scan, record.T_odom_base)
    map = mapper.finish()

continue_from: a Map to go on with. The scans that come are of another log, and the robot may stand
anywhere; what they show is joined to the map where the two share places, in the map's axes.
audit: match pairs of scans against the finished map. num_threads: 0 for all processors; any number
gives the same map. Threads may share a mapper: they take turns.)")
      .def(py::init(&mapper_from),
           py::kw_only(),
           py::arg("continue_from") = py::none(),
           py::arg("audit") = true,
           py::arg("num_threads") = 0)
      .def(
          "add",
          [](PyMapper& self,
             const py::object& scan,
             const std::optional<Pose2>& T_odom_base,
             const std::optional<double>& fov_deg) {
            const auto added = scan_from(scan, fov_deg);
            return self.with([&](Mapper& mapper) { return mapper.add(*added, T_odom_base); });
          },
          py::arg("scan"),
          py::arg("T_odom_base") = py::none(),
          py::kw_only(),
          py::arg("fov_deg") = py::none(),
          R"(The next scan, with the robot's pose by wheel odometry where there is one.

scan: a Scan, or an array of ranges (N,) in m over fov_deg degrees (180). Returns a TrackedPose.
Raises ParameterError where the scan's geometry is not valid or a pose is not finite.)")
      .def(
          "add_turn_rate",
          [](PyMapper& self,
             double turn_rad_per_s,
             double stamp_s,
             const std::optional<std::int64_t>& stamp_ns) {
            const Timestamp stamp = stamp_from(stamp_s, stamp_ns);
            self.with([&](Mapper& mapper) { mapper.add_turn_rate(stamp, turn_rad_per_s); });
          },
          py::arg("turn_rad_per_s"),
          py::kw_only(),
          py::arg("stamp_s") = 0.0,
          py::arg("stamp_ns") = py::none(),
          "A sample of a gyro, counterclockwise seen from above, in the order of time with the "
          "scans.")
      .def(
          "finish",
          [](PyMapper& self) {
            MappedLog mapped;
            mapped.map = self.with([](Mapper& mapper) { return mapper.finish(); });
            return PyMap(std::move(mapped));
          },
          "The Map of all scans so far; more may follow.")
      .def("__len__", [](PyMapper& self) {
        return self.with([](Mapper& mapper) { return mapper.num_scans(); });
      });
}

}  // namespace

void bind_mapping(py::module_& module) {
  bind_tracked_pose(module);
  bind_mapper(module);
  module.def("merge",
             &merged_map_of,
             py::arg("maps"),
             py::kw_only(),
             py::arg("num_threads") = 0,
             R"(One Map of several, in the frame of the first: what `setsquare merge` does.

maps: a list of Map of one building, found by the places that they share; where walls changed the
newer wins. Raises FileError with the reason where one shares no place with the others,
ParameterError where one cannot be gone on with (preset "paper").)");
  module.def("map_log",
             &map_log_of,
             py::arg("path"),
             py::kw_only(),
             py::arg("odometry") = true,
             py::arg("audit") = true,
             py::arg("preset") = "default",
             py::arg("continue_from") = py::none(),
             py::arg("num_threads") = 0,
             py::arg("progress") = py::none(),
             R"(Maps a log: what `setsquare map` does, in one call.

path: as read_log takes it, whose further options are taken, too.
odometry: use the wheels where the log has them. audit: match pairs against the finished map.
preset: "default", or "paper" for the method of Bando et al. 2014.
continue_from: a Map to go on with, see Mapper.
num_threads: 0 for all processors; any number gives the same map.
progress: called a few times a second with the share of the log that has been read, 0 to 1, or None.

Returns a Map. Other threads run meanwhile; Ctrl-C ends it while the log is read. Raises FileError, FormatError,
ParameterError.)");
}

}  // namespace setsquare::python
