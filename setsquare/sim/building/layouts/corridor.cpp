// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/sim/building/layouts/layouts.hpp"
#include "setsquare/sim/building/openings.hpp"
#include "setsquare/sim/building/wing.hpp"

namespace setsquare {

BuildingSketch sketch_corridor(Random& random) {
  constexpr double kLongest_m = 78.0;
  BuildingSketch sketch;
  const double length = random.uniform(40.0, 70.0);
  std::vector<Wing> wings{make_wing({}, length, random)};
  const bool has_bend = random.chance(0.4);
  if (has_bend) {
    // A bend near the end: the second corridor begins where the first one ends.
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    const Pose2 T_wing_bend{length - wings[0].half_width_m, 0.0, side * 0.5 * kPi};
    wings.push_back(make_wing(T_wing_bend, random.uniform(8.0, 16.0), random));
    wings[1].half_width_m = wings[0].half_width_m;
    wings[1].route_y_m = 0.0;
    wings[0].route_y_m = 0.0;
    wings[1].rows_from_m = wings[0].half_width_m + 0.3;
  }
  for (Wing& wing : wings) {
    wing.rows.open_share = random.uniform(0.35, 0.6);
    wing.rows.bare_share = random.uniform(0.2, 0.45);
    wing.rows.min_width_m = 2.8;
    wing.rows.max_width_m = random.uniform(5.0, 8.0);
    add_wing_corridor(sketch, wing, random);
  }
  for (Wing& wing : wings) add_wing_rooms(sketch, wing, random);
  // The robot drives a part of the corridor, so that it has the time to look into some rooms.
  const double start_x = has_bend ? length - random.uniform(18.0, 26.0) : random.uniform(0.8, 6.0);
  if (has_bend) {
    append_wing_route(
        sketch, wings[0], start_x, wings[1].T_map_wing.x_m, kLongest_m - 14.0, random);
    append_wing_route(sketch, wings[1], 0.0, wings[1].length_m - 1.2, kLongest_m, random);
  } else {
    append_wing_route(
        sketch, wings[0], start_x, start_x + random.uniform(24.0, 32.0), kLongest_m, random);
  }
  hang_leaves(sketch, random);
  for (const Wing& wing : wings) furnish_wing(sketch, wing, random);
  return sketch;
}

}  // namespace setsquare
