// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/building/openings.hpp"
#include "setsquare/sim/building/wing.hpp"

// The hallway of section 5.1 and Figure 4: a corridor about 20 m long that another one leaves at a
// right angle. The robot drives towards the junction, turns into the second corridor in a wide arc
// and drives on: three steps of 0.4 m, nine of 10 deg, two of 0.4 m make the 15 scans.

namespace setsquare {

namespace {

constexpr double kArcRadius_m = 1.8;
constexpr double kBeforeArc_m = 1.2;
constexpr double kAfterArc_m = 2.5;

/// Along x, a quarter turn to the left, along y.
std::vector<Eigen::Vector2d> hallway_route() {
  std::vector<Eigen::Vector2d> route_m{{0.0, 0.0}};
  for (int i = 0; i <= 9; ++i) {
    const double turned = rad_from_deg(10.0 * i);
    route_m.emplace_back(kBeforeArc_m + kArcRadius_m * std::sin(turned),
                         kArcRadius_m * (1.0 - std::cos(turned)));
  }
  route_m.emplace_back(kBeforeArc_m + kArcRadius_m, kArcRadius_m + kAfterArc_m);
  return route_m;
}

}  // namespace

Building make_paper_hallway(std::uint64_t seed) {
  Random random(sub_seed(seed, 100));
  BuildingSketch sketch;
  const double start_x = random.uniform(5.5, 7.5);
  std::vector<Wing> wings{make_wing({-start_x, 0.0, 0.0}, random.uniform(18.0, 22.0), random)};
  wings.push_back(
      make_wing({kBeforeArc_m + kArcRadius_m, 0.0, 0.5 * kPi}, random.uniform(9.0, 12.0), random));
  for (Wing& wing : wings) {
    wing.half_width_m = random.uniform(1.0, 1.25);
    wing.route_y_m = 0.0;
    wing.rows.open_share = 0.6;
    wing.rows.bare_share = 0.15;
    wing.people_per_m = 0.05;
    wing.rows_from_m = &wing == &wings.front() ? 0.3 : wings.front().half_width_m + 0.3;
    add_wing_corridor(sketch, wing, random);
  }
  for (Wing& wing : wings) add_wing_rooms(sketch, wing, random);
  sketch.route_m = hallway_route();
  hang_leaves(sketch, random);
  for (const Wing& wing : wings) furnish_wing(sketch, wing, random);
  return finish(sketch, rad_from_deg(random.uniform(-10.0, 10.0)));
}

}  // namespace setsquare
