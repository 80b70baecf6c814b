// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/building_partitions.hpp"

#include <cmath>
#include <cstddef>

#include "setsquare/core/angle.hpp"

namespace setsquare {

void add_partitions(
    BuildingSketch& sketch, RoomFloor& floor, int num_tries, double longest_m, Random& random) {
  constexpr double kOffWall_m = 0.01;
  const ConvexPolygon outline = floor.outline();
  for (int i = 0; i < num_tries; ++i) {
    const int last_side = static_cast<int>(outline.size()) - 1;
    const auto k = static_cast<std::size_t>(random.integer(0, last_side));
    const Eigen::Vector2d side = outline[(k + 1) % outline.size()] - outline[k];
    const Eigen::Vector2d root = outline[k] + random.uniform(0.1, 0.9) * side;
    const double lean = rad_from_deg(random.chance(0.6) ? 0.0 : random.uniform(-25.0, 25.0));
    const double thickness = random.uniform(0.08, 0.2);
    const double length = random.uniform(0.35, 1.0) * longest_m;
    const Pose2 T_map_root{root.x(), root.y(), std::atan2(side.y(), side.x()) + 0.5 * kPi + lean};
    const double from = kOffWall_m + 0.5 * thickness * std::abs(std::tan(lean));
    const ConvexPolygon partition =
        rectangle(T_map_root, from, -0.5 * thickness, from + length, 0.5 * thickness);
    if (floor.take(partition)) add_outline(sketch, partition, Material::kWall);
  }
}

}  // namespace setsquare
