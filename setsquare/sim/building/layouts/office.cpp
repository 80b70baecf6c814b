// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/sim/building/layouts/layouts.hpp"
#include "setsquare/sim/building/openings.hpp"
#include "setsquare/sim/building/wing.hpp"

namespace setsquare {
namespace {

/// A second corridor that leaves the first one at a right angle.
Wing make_branch(const Wing& first, double leaves_x_m, Random& random) {
  const double side = random.chance(0.5) ? 1.0 : -1.0;
  const Pose2 T_wing_branch{leaves_x_m, 0.0, side * 0.5 * kPi};
  Wing branch = make_wing(first.T_map_wing * T_wing_branch, random.uniform(12.0, 20.0), random);
  branch.rows_from_m = first.half_width_m + 0.3;
  return branch;
}

void share_open_rooms(Wing& wing, Random& random) {
  wing.rows.open_share = random.uniform(0.7, 0.95);
  wing.rows.min_width_m = random.uniform(2.3, 2.8);
  wing.rows.max_width_m = random.uniform(3.8, 6.0);
}

}  // namespace

BuildingSketch sketch_office(Random& random) {
  constexpr double kLongest_m = 78.0;
  BuildingSketch sketch;
  std::vector<Wing> wings{make_wing({}, random.uniform(18.0, 30.0), random)};
  const bool has_branch = random.chance(0.6);
  const double leaves_x = wings[0].length_m * random.uniform(0.4, 0.75);
  if (has_branch) wings.push_back(make_branch(wings[0], leaves_x, random));
  for (Wing& wing : wings) {
    share_open_rooms(wing, random);
    add_wing_corridor(sketch, wing, random);
  }
  for (Wing& wing : wings) add_wing_rooms(sketch, wing, random);
  const double start_x = random.uniform(0.8, 4.0);
  if (has_branch) {
    // The corner lies where the two centre lines of travel meet.
    const double corner_x = (wings[0].T_map_wing.inverse() * wings[1].T_map_wing *
                             Eigen::Vector2d(0.0, wings[1].route_y_m))
                                .x();
    const double corner_in_branch = (wings[1].T_map_wing.inverse() * wings[0].T_map_wing *
                                     Eigen::Vector2d(0.0, wings[0].route_y_m))
                                        .x();
    append_wing_route(sketch, wings[0], start_x, corner_x, 0.6 * kLongest_m, random);
    append_wing_route(
        sketch, wings[1], corner_in_branch, wings[1].length_m - 1.2, kLongest_m, random);
  } else {
    append_wing_route(sketch, wings[0], start_x, wings[0].length_m - 1.2, kLongest_m, random);
  }
  hang_leaves(sketch, random);
  for (const Wing& wing : wings) furnish_wing(sketch, wing, random);
  return sketch;
}

}  // namespace setsquare
