// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <map>
#include <utility>
#include <vector>

#include "setsquare/sim/building/rooms.hpp"
#include "setsquare/sim/building/sketch.hpp"
#include "setsquare/sim/random.hpp"

namespace setsquare {

/// A crossing of two corridors: its column and its row.
struct Crossing {
  std::size_t column = 0;
  std::size_t row = 0;
  auto operator<=>(const Crossing&) const = default;
};

/// A stretch of corridor between neighbouring crossings, the lesser one first.
using CorridorEdge = std::pair<Crossing, Crossing>;
[[nodiscard]] CorridorEdge edge_between(const Crossing& a, const Crossing& b);

/// Offices between corridors that cross: blocks of two rows of rooms, back to back.
struct BlockLayout {
  std::vector<double> x_m;             ///< Middle lines of the corridors along y ...
  std::vector<double> y_m;             ///< ... and along x.
  std::vector<double> half_width_x_m;  ///< Of the corridors along y: half their extent in x.
  std::vector<double> half_width_y_m;
  std::vector<ConvexPolygon> corridors;
  std::map<CorridorEdge, std::vector<Room>> rooms;  ///< Those that can be entered from there.

  [[nodiscard]] Eigen::Vector2d position(const Crossing& crossing) const {
    return {x_m[crossing.column], y_m[crossing.row]};
  }
};

/// Adds corridors and rooms to the sketch; at least one block either way.
[[nodiscard]] BlockLayout add_blocks(BuildingSketch& sketch,
                                     std::size_t num_columns,
                                     std::size_t num_rows,
                                     Random& random);

}  // namespace setsquare
