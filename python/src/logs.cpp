// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// read_log: records of any format, one by one.
#include <fmt/core.h>
#include <pybind11/stl.h>

#include <memory>
#include <mutex>
#include <optional>

#include "python/src/bindings.hpp"
#include "python/src/conversions.hpp"
#include "python/src/log_options.hpp"
#include "setsquare/io/logs/log_chain.hpp"
#include "setsquare/io/logs/log_reader.hpp"

namespace py = pybind11;

namespace setsquare::python {
namespace {

/// A record of its own: the reader's is used again.
struct PyRecord {
  LogRecord record;
  std::shared_ptr<Scan> scan;  ///< None where it is no scan.
};

std::string name_of(RecordKind kind) {
  switch (kind) {
    case RecordKind::kScan:
      return "scan";
    case RecordKind::kOdometry:
      return "odometry";
    case RecordKind::kTruePose:
      return "true_pose";
    case RecordKind::kTurnRate:
      return "turn_rate";
  }
  return {};
}

/// A reader that several threads may use: each record goes to one of them.
class PyReader {
 public:
  explicit PyReader(std::unique_ptr<LogReader> reader) : reader_(std::move(reader)) {}

  /// Calls `function` with the reader while no other thread does, with Python's interpreter free.
  template <typename Function>
  auto with(Function function) {
    return without_gil([&] {
      const std::lock_guard<std::mutex> lock(mutex_);
      return function(*reader_);
    });
  }

 private:
  std::mutex mutex_;
  std::unique_ptr<LogReader> reader_;
};

PyRecord record_of_next(PyReader& self) {
  std::optional<LogRecord> next = self.with([](LogReader& reader) {
    const LogRecord* record = reader.next();
    return record == nullptr ? std::nullopt : std::optional<LogRecord>(*record);
  });
  if (!next) throw py::stop_iteration();
  PyRecord made{std::move(*next), nullptr};
  if (made.record.kind == RecordKind::kScan)
    made.scan = std::make_shared<Scan>(std::move(made.record.scan));
  return made;
}

void bind_record(py::module_& module) {
  py::class_<PyRecord>(
      module, "LogRecord", "One record of a log; None where a field has no meaning.")
      .def_property_readonly(
          "kind",
          [](const PyRecord& self) { return name_of(self.record.kind); },
          R"("scan", "odometry", "true_pose" or "turn_rate".)")
      .def_property_readonly(
          "sensor",
          [](const PyRecord& self) { return self.record.sensor; },
          "Name of the sensor in the log.")
      .def_readonly("scan", &PyRecord::scan, "The Scan, where it is one.")
      .def_property_readonly(
          "stamp_ns", [](const PyRecord& self) { return self.record.stamp.ns; }, "Sensor time, ns.")
      .def_property_readonly(
          "stamp_s",
          [](const PyRecord& self) { return self.record.stamp.seconds(); },
          "The same in seconds; rounded to what a double holds.")
      .def_property_readonly(
          "T_odom_base",
          [](const PyRecord& self) { return self.record.T_odom_base; },
          "The robot's pose by wheel odometry.")
      .def_property_readonly(
          "T_map_base",
          [](const PyRecord& self) { return self.record.T_map_base; },
          "The robot's true pose, of a kind \"true_pose\".")
      .def_property_readonly(
          "turn_rad_per_s",
          [](const PyRecord& self) { return self.record.turn_rad_per_s; },
          "How fast it turns, counterclockwise, by wheels or gyro.")
      .def("__repr__", [](const PyRecord& self) {
        return fmt::format("LogRecord({}, {}, stamp_s={})",
                           name_of(self.record.kind),
                           self.record.sensor,
                           to_string(self.record.stamp));
      });
}

/// Throws TypeError for a name that is none, cast_error for a value of another type.
void set_option(LogOptions& log, const std::string& name, const py::handle& value) {
  const auto number = [&](double unit) { return unit * value.cast<double>(); };
  if (name == "sensor")
    log.sensor = value.cast<std::string>();
  else if (name == "odometry_topic")
    log.odometry_topic = value.cast<std::string>();
  else if (name == "fov_deg")
    log.field_of_view_rad = number(rad_from_deg(1.0));
  else if (name == "bearing_step_deg")
    log.bearing_step_rad = number(rad_from_deg(1.0));
  else if (name == "max_range_m")
    log.max_range_m = number(1.0);
  else if (name == "range_scale")
    log.range_scale = number(1.0);
  else if (name == "ignored_ranges_m")
    log.ignored_ranges_m = value.cast<std::vector<double>>();
  else if (name == "mirror_scans")
    log.mirrors_scans = value.cast<bool>();
  else if (name == "sweep_time_s")
    log.sweep_time_s = number(1.0);
  else if (name == "from_s")
    log.window.from_s = number(1.0);
  else if (name == "to_s")
    log.window.to_s = number(1.0);
  else if (name == "max_rate_hz")
    log.window.max_rate_hz = number(1.0);
  else if (name == "mountings")
    log.mountings = value.cast<std::map<std::string, Pose2>>();
  else
    throw py::type_error(fmt::format("unexpected keyword argument '{}'", name));
}

}  // namespace

LogOptions log_options_from(const py::kwargs& options) {
  LogOptions log;
  for (const auto& [key, value] : options) {
    const auto name = key.cast<std::string>();
    try {
      set_option(log, name, value);
    } catch (const py::cast_error&) {
      throw py::type_error(fmt::format("keyword argument '{}' has a value of a wrong type", name));
    }
  }
  log.validate();
  return log;
}

std::vector<std::string> paths_from(const py::object& path) {
  if (py::isinstance<py::list>(path) || py::isinstance<py::tuple>(path)) {
    std::vector<std::string> paths;
    for (const py::handle one : path)
      paths.push_back(path_from(py::reinterpret_borrow<py::object>(one)));
    return paths;
  }
  return {path_from(path)};
}

void bind_logs(py::module_& module) {
  bind_record(module);
  py::class_<PyReader>(module, "LogReader", R"(Reads a log record by record, in bounded memory.

Threads may share it: each record goes to one of them.)")
      .def("__iter__", [](const py::object& self) { return self; })
      .def("__next__", &record_of_next)
      .def_property_readonly(
          "format",
          [](PyReader& self) {
            return self.with([](LogReader& reader) { return reader.format(); });
          },
          R"(What kind of log it is: "CARMEN log".)")
      .def_property_readonly(
          "front_sensor",
          [](PyReader& self) {
            return self.with([](LogReader& reader) { return reader.front_sensor(); });
          },
          "The laser that is read by default.")
      .def_property_readonly(
          "problems",
          [](PyReader& self) {
            return self.with([](LogReader& reader) { return summary(reader.problems()); });
          },
          "Damaged records so far, in a sentence; empty where there is none.");
  module.def(
      "read_log",
      [](const py::object& path, bool scans_only, const py::kwargs& options) {
        LogOptions log = log_options_from(options);
        log.scans_only = scans_only;
        const std::vector<std::string> paths = paths_from(path);
        return std::make_unique<PyReader>(without_gil([&] { return open_logs(paths, log); }));
      },
      py::arg("path"),
      py::arg("scans_only") = true,
      R"(Opens a log of any format and iterates over its records.

path: a file, plain or packed, the folder of a ROS 2 bag, or a list of those of one run.
scans_only: leave out odometry, true poses and turn rates that come without a scan.
Further options, by keyword, as those of the command: sensor, odometry_topic, fov_deg,
    bearing_step_deg, max_range_m, range_scale, ignored_ranges_m, mirror_scans, sweep_time_s,
    from_s, to_s, max_rate_hz, mountings ({sensor: (x_m, y_m, theta_rad)}).

Returns a LogReader. Raises FileError, FormatError, ParameterError.)");
}

}  // namespace setsquare::python
