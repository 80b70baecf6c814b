// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// OccupancyGrid as arrays.
#include <fmt/core.h>

#include <cmath>

#include "python/src/bindings.hpp"
#include "python/src/conversions.hpp"
#include "setsquare/grid/occupancy_grid.hpp"

namespace py = pybind11;

namespace setsquare::python {
namespace {

std::vector<py::ssize_t> shape_of(const OccupancyGrid& grid) {
  return {grid.num_rows(), grid.num_columns()};
}

py::array_t<float> log_odds_of(const py::object& self) {
  const auto& grid = self.cast<const OccupancyGrid&>();
  py::array_t<float> array(shape_of(grid), grid.values().data(), self);
  array.attr("flags").attr("writeable") = false;
  return array;
}

py::array_t<float> probability_of(const OccupancyGrid& grid) {
  py::array_t<float> array(shape_of(grid));
  float* to = array.mutable_data();
  for (const float log_odds : grid.values()) *to++ = 1.0F / (1.0F + std::exp(-log_odds));
  return array;
}

py::array_t<std::int8_t> occupancy_of(const OccupancyGrid& grid) {
  py::array_t<std::int8_t> array(shape_of(grid));
  std::int8_t* to = array.mutable_data();
  for (const float log_odds : grid.values()) {
    *to++ = static_cast<std::int8_t>(log_odds > 0.0F ? 100 : log_odds < 0.0F ? 0 : -1);
  }
  return array;
}

}  // namespace

void bind_grids(py::module_& module) {
  py::class_<OccupancyGrid>(module, "OccupancyGrid", R"(Square cells: free, occupied or unknown.

Row 0 is the lowest: draw with imshow(..., origin="lower", extent=grid.extent_m).)")
      .def_property_readonly("log_odds",
                             &log_odds_of,
                             R"(float32 array of shape (rows, columns): log of the odds of a wall.

0 where nothing is known; read-only, the grid's own memory.)")
      .def_property_readonly("probability",
                             &probability_of,
                             "float32 array of shape (rows, columns), 0.5 where nothing is known.")
      .def_property_readonly(
          "occupancy",
          &occupancy_of,
          "int8 array of shape (rows, columns) as ROS has it: -1 unknown, 0 free, 100 occupied.")
      .def_property_readonly("resolution_m", &OccupancyGrid::resolution_m, "Side of a cell.")
      .def_property_readonly(
          "T_map_grid", &OccupancyGrid::T_map_grid, "Pose of the lower left corner in the map.")
      .def_property_readonly(
          "extent_m",
          [](const OccupancyGrid& grid) {
            const Pose2& corner = grid.T_map_grid();
            return py::make_tuple(corner.x_m,
                                  corner.x_m + grid.resolution_m() * grid.num_columns(),
                                  corner.y_m,
                                  corner.y_m + grid.resolution_m() * grid.num_rows());
          },
          "(left, right, bottom, top) in the map, for a grid along the map's axes.")
      .def("__repr__", [](const OccupancyGrid& grid) {
        return fmt::format("OccupancyGrid({} x {} cells of {:g} m)",
                           grid.num_columns(),
                           grid.num_rows(),
                           grid.resolution_m());
      });
}

}  // namespace setsquare::python
