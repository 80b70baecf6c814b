// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/scaling/block_layout.hpp"

#include <algorithm>
#include <iterator>

#include "setsquare/core/angle.hpp"

namespace setsquare {
namespace {

constexpr double kToCorner_m = 0.35;  // From the end of a row of rooms to the next corridor.

/// Middle lines of corridors, about 13 m apart.
std::vector<double> corridor_lines(std::size_t num_blocks, Random& random) {
  std::vector<double> lines_m = {0.0};
  for (std::size_t i = 0; i < num_blocks; ++i) {
    lines_m.push_back(lines_m.back() + random.uniform(11.5, 14.5));
  }
  return lines_m;
}

std::vector<double> half_widths(std::size_t num_corridors, Random& random) {
  std::vector<double> widths_m(num_corridors);
  for (double& width_m : widths_m) width_m = random.uniform(0.85, 1.3);
  return widths_m;
}

/// The inside of a block, between its four corridors.
struct Block {
  double x0_m, y0_m, x1_m, y1_m;
};

/// Its walls, each as the place of a row: x along the wall, y into the block.
struct BlockWall {
  Pose2 T_map_wall;
  double length_m;
  CorridorEdge edge;
};

Block block_at(const BlockLayout& layout, std::size_t i, std::size_t j) {
  return {layout.x_m[i] + layout.half_width_x_m[i],
          layout.y_m[j] + layout.half_width_y_m[j],
          layout.x_m[i + 1] - layout.half_width_x_m[i + 1],
          layout.y_m[j + 1] - layout.half_width_y_m[j + 1]};
}

/// Bottom and top, then left and right.
std::vector<BlockWall> walls_of(const Block& block, std::size_t i, std::size_t j) {
  const double width_m = block.x1_m - block.x0_m;
  const double height_m = block.y1_m - block.y0_m;
  return {
      {{block.x0_m, block.y0_m, 0.0}, width_m, {{i, j}, {i + 1, j}}},
      {{block.x1_m, block.y1_m, kPi}, width_m, {{i, j + 1}, {i + 1, j + 1}}},
      {{block.x0_m, block.y1_m, -0.5 * kPi}, height_m, {{i, j}, {i, j + 1}}},
      {{block.x1_m, block.y0_m, 0.5 * kPi}, height_m, {{i + 1, j}, {i + 1, j + 1}}},
  };
}

RoomRow row_along(const BlockWall& wall, double depth_m, double open_share) {
  RoomRow row;
  row.T_map_row = wall.T_map_wall * Pose2{kToCorner_m, 0.0, 0.0};
  row.length_m = wall.length_m - 2.0 * kToCorner_m;
  row.depth_m = depth_m;
  row.open_share = open_share;
  row.min_width_m = 2.4;
  row.max_width_m = 5.0;
  return row;
}

void add_corridors(BuildingSketch& sketch, BlockLayout& layout) {
  constexpr double kShort_m = 0.05;  // No side of one corridor lies on a side of another.
  const auto& x = layout.x_m;
  const auto& y = layout.y_m;
  const double left = x.front() - layout.half_width_x_m.front() + kShort_m;
  const double right = x.back() + layout.half_width_x_m.back() - kShort_m;
  const double low = y.front() - layout.half_width_y_m.front() + kShort_m;
  const double high = y.back() + layout.half_width_y_m.back() - kShort_m;
  for (std::size_t j = 0; j < y.size(); ++j) {
    const double half = layout.half_width_y_m[j];
    layout.corridors.push_back(rectangle({}, left, y[j] - half, right, y[j] + half));
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double half = layout.half_width_x_m[i];
    layout.corridors.push_back(rectangle({}, x[i] - half, low, x[i] + half, high));
  }
  for (const ConvexPolygon& outline : layout.corridors) sketch.spaces.push_back({outline, {}});
}

/// Closed doors and niches along the outer walls of the corridors at the rim.
void add_rim(BuildingSketch& sketch, const BlockLayout& layout, Random& random) {
  const double left = layout.x_m.front() - layout.half_width_x_m.front();
  const double right = layout.x_m.back() + layout.half_width_x_m.back();
  const double low = layout.y_m.front() - layout.half_width_y_m.front();
  const double high = layout.y_m.back() + layout.half_width_y_m.back();
  const BlockWall walls[] = {{{right, low, kPi}, right - left, {}},
                             {{left, high, 0.0}, right - left, {}},
                             {{left, low, 0.5 * kPi}, high - low, {}},
                             {{right, high, -0.5 * kPi}, high - low, {}}};
  for (const BlockWall& wall : walls) {
    static_cast<void>(add_room_row(sketch, row_along(wall, 4.0, 0.0), random));
  }
}

}  // namespace

CorridorEdge edge_between(const Crossing& a, const Crossing& b) {
  return {std::min(a, b), std::max(a, b)};
}

BlockLayout add_blocks(BuildingSketch& sketch,
                       std::size_t num_columns,
                       std::size_t num_rows,
                       Random& random) {
  BlockLayout layout{.x_m = corridor_lines(num_columns, random),
                     .y_m = corridor_lines(num_rows, random),
                     .half_width_x_m = half_widths(num_columns + 1, random),
                     .half_width_y_m = half_widths(num_rows + 1, random),
                     .corridors = {},
                     .rooms = {}};
  add_corridors(sketch, layout);
  std::vector<BlockWall> closed;
  for (std::size_t i = 0; i < num_columns; ++i) {
    for (std::size_t j = 0; j < num_rows; ++j) {
      const Block block = block_at(layout, i, j);
      const std::vector<BlockWall> walls = walls_of(block, i, j);
      // Neighbouring blocks are turned by a right angle.
      const std::size_t first = (i + j) % 2 == 0 ? 0 : 2;
      const double across_m = first == 0 ? block.y1_m - block.y0_m : block.x1_m - block.x0_m;
      for (std::size_t w = 0; w < walls.size(); ++w) {
        if (w / 2 != first / 2) {
          closed.push_back(walls[w]);
          continue;
        }
        std::vector<Room> rooms = add_room_row(
            sketch, row_along(walls[w], 0.5 * across_m - 0.35, random.uniform(0.7, 0.95)), random);
        std::vector<Room>& entered = layout.rooms[walls[w].edge];
        std::move(rooms.begin(), rooms.end(), std::back_inserter(entered));
      }
    }
  }
  for (const BlockWall& wall : closed) {
    static_cast<void>(add_room_row(sketch, row_along(wall, 4.0, 0.0), random));
  }
  add_rim(sketch, layout, random);
  return layout;
}

}  // namespace setsquare
