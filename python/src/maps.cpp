// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Map: what it knows as arrays, what it doubts, and its files.
#include "python/src/maps.hpp"

#include <fmt/core.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <optional>

#include "python/src/bindings.hpp"
#include "python/src/conversions.hpp"
#include "python/src/trajectories.hpp"
#include "setsquare/io/logs/faults/findings_json.hpp"
#include "setsquare/io/map_file/map_file.hpp"
#include "setsquare/map/map_summary.hpp"
#include "setsquare/map/map_verdict.hpp"
#include "setsquare/report/map/save_map.hpp"

namespace py = pybind11;

namespace setsquare::python {
namespace {

/// A row of Map.scans.
struct ScanRow {
  std::int64_t stamp_ns;
  char status[12];
  bool is_placed;
  double x_m;
  double y_m;
  double theta_rad;
  double sensor_x_m;
  double sensor_y_m;
  double sensor_theta_rad;
  double score;
  double position_sigma_m;
  double heading_sigma_rad;
};

/// A row of Map.closures.
struct ClosureRow {
  std::int64_t scan_i;
  std::int64_t scan_j;
  double x_m;
  double y_m;
  double theta_rad;
  char axes[4];
  bool is_accepted;
  double weight;
};

/// A row of PoseGraph.constraints.
struct ConstraintRow {
  std::int64_t from_node;
  std::int64_t to_node;
  bool is_loop_closure;
  double x_m;
  double y_m;
  double theta_rad;
  double information[3][3];
  double weight;
};

/// A row of Map.sessions.
struct SessionRow {
  std::int64_t first_scan;
  std::int64_t num_scans;
  std::int64_t recency;
};

/// A text of at most N characters, padded with zeros as NumPy's are.
template <std::size_t N>
void set_text(char (&to)[N], std::string_view text) {
  std::fill(std::begin(to), std::end(to), '\0');
  std::copy_n(text.begin(), std::min(N, text.size()), std::begin(to));
}

template <typename Row, typename Values, typename MakeRow>
py::array_t<Row> rows_of(const Values& values, MakeRow make_row) {
  py::array_t<Row> rows(static_cast<py::ssize_t>(values.size()));
  std::transform(values.begin(), values.end(), rows.mutable_data(), make_row);
  return rows;
}

ScanRow row_of(const MappedScan& scan) {
  ScanRow row{.stamp_ns = scan.stamp.ns,
              .status = {},
              .is_placed = scan.is_placed,
              .x_m = scan.T_map_base.x_m,
              .y_m = scan.T_map_base.y_m,
              .theta_rad = scan.T_map_base.theta_rad,
              .sensor_x_m = scan.T_map_sensor.x_m,
              .sensor_y_m = scan.T_map_sensor.y_m,
              .sensor_theta_rad = scan.T_map_sensor.theta_rad,
              .score = scan.score,
              .position_sigma_m = scan.position_sigma_m,
              .heading_sigma_rad = scan.heading_sigma_rad};
  set_text(row.status, to_string(scan.status));
  return row;
}

ClosureRow row_of(const MappedClosure& mapped) {
  const LoopClosure& closure = mapped.closure;
  ClosureRow row{.scan_i = static_cast<std::int64_t>(mapped.scan_i),
                 .scan_j = static_cast<std::int64_t>(mapped.scan_j),
                 .x_m = closure.T_i_j.x_m,
                 .y_m = closure.T_i_j.y_m,
                 .theta_rad = closure.T_i_j.theta_rad,
                 .axes = {},
                 .is_accepted = closure.is_accepted,
                 .weight = closure.weight};
  set_text(row.axes,
           closure.axes == ClosureAxes::kX   ? "x"
           : closure.axes == ClosureAxes::kY ? "y"
                                             : "xy");
  return row;
}

ConstraintRow row_of(const Constraint& constraint) {
  ConstraintRow row{.from_node = static_cast<std::int64_t>(constraint.from),
                    .to_node = static_cast<std::int64_t>(constraint.to),
                    .is_loop_closure = constraint.kind == ConstraintKind::kLoopClosure,
                    .x_m = constraint.T_from_to.x_m,
                    .y_m = constraint.T_from_to.y_m,
                    .theta_rad = constraint.T_from_to.theta_rad,
                    .information = {},
                    .weight = constraint.weight};
  for (int i = 0; i < 9; ++i) row.information[i / 3][i % 3] = constraint.information(i / 3, i % 3);
  return row;
}

std::vector<std::string> save(const PyMap& self,
                              const py::object& folder,
                              const std::optional<std::string>& pose_of,
                              int num_threads) {
  const std::string path = path_from(folder);
  SaveMapOptions options = save_options_of(self.saved->record);
  if (pose_of) options.pose_of = is_of_sensor(*pose_of) ? PoseOf::kSensor : PoseOf::kBase;
  options.num_threads = threads_from(num_threads);
  return without_gil([&] { return save_map(self.map(), path, options); });
}

void save_file_of(const PyMap& self, const py::object& path) {
  const std::string name = path_from(path);
  without_gil([&] { save_map_file(self.map(), name, self.saved->record); });
}

PyMap load(const py::object& path) {
  const std::string name = path_from(path);
  return without_gil([&] { return PyMap(load_map_file(name)); });
}

void bind_doubt(py::module_& module) {
  py::class_<MapDoubt>(module, "MapDoubt", "A place where the map may be wrong, and why.")
      .def_property_readonly(
          "kind",
          [](const MapDoubt& doubt) { return std::string(to_string(doubt.kind)); },
          R"("contradicting pairs", "unknown length", "piece not joined" ...)")
      .def_readonly("reason", &MapDoubt::reason, "A sentence without its full stop.")
      .def_property_readonly(
          "place_m",
          [](const MapDoubt& doubt) {
            return py::make_tuple(doubt.place_m.x(), doubt.place_m.y());
          },
          "(x, y) in the map, of the robot.")
      .def_readonly("first_scan", &MapDoubt::first_scan, "Index into Map.scans.")
      .def_readonly("num_scans", &MapDoubt::num_scans, "In doubt, from first_scan on.")
      .def("__repr__", [](const MapDoubt& doubt) {
        return fmt::format("MapDoubt({} at ({:.1f}, {:.1f}) m: {})",
                           to_string(doubt.kind),
                           doubt.place_m.x(),
                           doubt.place_m.y(),
                           doubt.reason);
      });
}

/// Of Map.graph: its own memory is the map's.
struct PyGraph {
  std::shared_ptr<const SavedMap> saved;

  [[nodiscard]] const PoseGraph& graph() const { return saved->map.graph; }
};

void bind_graph(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(
      ConstraintRow, from_node, to_node, is_loop_closure, x_m, y_m, theta_rad, information, weight);
  py::class_<PyGraph>(
      module, "PoseGraph", "Poses of the robot at the keyframes, and what ties them.")
      .def_property_readonly(
          "nodes",
          [](const PyGraph& self) { return array_of(self.graph().T_map_node); },
          "float array of shape (N, 3): x and y in m, theta in rad, in the map.")
      .def_property_readonly(
          "constraints",
          [](const PyGraph& self) {
            return rows_of<ConstraintRow>(self.graph().constraints,
                                          [](const Constraint& one) { return row_of(one); });
          },
          R"(Structured array: from_node, to_node, is_loop_closure, x_m, y_m, theta_rad of to_node
seen from from_node, information (3, 3) in 1/m^2, 1/(m rad), 1/rad^2, weight 0 to 1.)")
      .def("__repr__", [](const PyGraph& self) {
        return fmt::format("PoseGraph({} nodes, {} constraints)",
                           self.graph().T_map_node.size(),
                           self.graph().constraints.size());
      });
}

std::string map_text(const PyMap& self) {
  const MapSummary summary = summary_of(self.map());
  const std::string verdict = map_verdict(self.map());
  return fmt::format("Map({} scans, {} keyframes, {:.0f} m{})",
                     summary.num_scans,
                     summary.num_keyframes,
                     summary.path_m,
                     verdict.empty() ? "" : "; " + verdict);
}

using MapClass = py::class_<PyMap>;

void bind_arrays(MapClass& map) {
  map.def(
         "trajectory",
         [](const PyMap& self, const std::string& pose_of) {
           return TrajectoryArrays{
               trajectory_of(self.map(), is_of_sensor(pose_of) ? PoseOf::kSensor : PoseOf::kBase)};
         },
         py::arg("pose_of") = "base",
         R"(The poses of the scans that are placed, of the robot ("base") or the laser ("sensor").)")
      .def_property_readonly(
          "scans",
          [](const PyMap& self) {
            return rows_of<ScanRow>(self.map().scans,
                                    [](const MappedScan& scan) { return row_of(scan); });
          },
          R"(Structured array, a row a scan: stamp_ns, status (bytes), is_placed, x_m, y_m, theta_rad of
the robot, the same of the sensor, score, position_sigma_m, heading_sigma_rad (standard deviations;
infinite where the scan is not placed).)")
      .def_property_readonly(
          "keyframes",
          [](const PyMap& self) {
            return rows_of<std::int64_t>(self.map().keyframes, [](std::size_t index) {
              return static_cast<std::int64_t>(index);
            });
          },
          "int64 array: indices into scans.")
      .def_property_readonly(
          "closures",
          [](const PyMap& self) {
            return rows_of<ClosureRow>(self.map().closures,
                                       [](const MappedClosure& one) { return row_of(one); });
          },
          R"(Structured array of the places compared: scan_i, scan_j, x_m, y_m, theta_rad of j seen from
i, axes bound (bytes "xy", "x", "y"), is_accepted, weight 0 to 1.)")
      .def_property_readonly(
          "graph", [](const PyMap& self) { return PyGraph{self.saved}; }, "The pose graph.")
      .def_property_readonly(
          "sessions",
          [](const PyMap& self) {
            return rows_of<SessionRow>(self.map().sessions, [](const MapSession& session) {
              return SessionRow{static_cast<std::int64_t>(session.first_scan),
                                static_cast<std::int64_t>(session.num_scans),
                                static_cast<std::int64_t>(session.recency)};
            });
          },
          R"(Structured array, a row a log that the map was made of: first_scan and num_scans of scans, recency
(where walls changed, the grid shows what the highest saw).)")
      .def(
          "grid",
          [](const PyMap& self, int num_threads) {
            return without_gil(
                [&] { return occupancy_grid(self.map(), threads_from(num_threads)); });
          },
          py::arg("num_threads") = 0,
          "The occupancy grid. num_threads: 0 for all processors; any gives the same grid.");
}

void bind_outputs(MapClass& map) {
  map.def(
         "save",
         &save,
         py::arg("folder"),
         py::kw_only(),
         py::arg("pose_of") = py::none(),
         py::arg("num_threads") = 0,
         R"(Writes every file that `setsquare map` writes, but for timing.json, all of them or none.

pose_of: whose poses trajectory.tum holds, "base" or "sensor"; None: as the map was saved before, else
"base". Returns the files' names. Raises FileError, ParameterError.)")
      .def("save_file",
           &save_file_of,
           py::arg("path"),
           R"(Writes the map file alone, map.setsquare, which Map.load reads. Raises FileError.)")
      .def_static(
          "load",
          &load,
          py::arg("path"),
          R"(Reads a map file, or that of the folder which `setsquare map` wrote: the map as it was saved, bit
for bit. Raises FileError, and FormatError where it is damaged or a newer Setsquare wrote it.)")
      .def(
          "to_png",
          [](const PyMap& self, int num_threads) {
            return py::bytes(
                without_gil([&] { return map_png(self.map(), threads_from(num_threads)); }));
          },
          py::arg("num_threads") = 0,
          "map.png: the map for people, as bytes.")
      .def_property_readonly(
          "verdict",
          [](const PyMap& self) { return map_verdict(self.map()); },
          "\"consistent (...)\" or \"doubtful in N places (...)\"; empty where not audited.")
      .def_property_readonly(
          "doubts", [](const PyMap& self) { return self.map().doubts; }, "Where it may be wrong.")
      .def_property_readonly(
          "findings",
          [](const PyMap& self) {
            std::vector<std::string> texts;
            for (const LogFinding& finding :
                 findings_from_json(self.saved->record.run.findings_json))
              texts.push_back(text_of(finding));
            return texts;
          },
          "What is wrong with the log, a sentence each.")
      .def_property_readonly(
          "format", [](const PyMap& self) { return self.saved->record.run.format; }, "Of the log.")
      .def("__len__", [](const PyMap& self) { return self.map().scans.size(); })
      .def("__repr__", [](const PyMap& self) { return map_text(self); });
}

}  // namespace

void bind_maps(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(ScanRow,
                       stamp_ns,
                       status,
                       is_placed,
                       x_m,
                       y_m,
                       theta_rad,
                       sensor_x_m,
                       sensor_y_m,
                       sensor_theta_rad,
                       score,
                       position_sigma_m,
                       heading_sigma_rad);
  PYBIND11_NUMPY_DTYPE(ClosureRow, scan_i, scan_j, x_m, y_m, theta_rad, axes, is_accepted, weight);
  PYBIND11_NUMPY_DTYPE(SessionRow, first_scan, num_scans, recency);
  bind_doubt(module);
  bind_graph(module);
  MapClass map(module, "Map", R"(What a mapper knows: poses, closures, doubts, the grid.

The map's axes are those of the building's main frame: its walls run along x and y.)");
  bind_arrays(map);
  bind_outputs(map);
}

}  // namespace setsquare::python
