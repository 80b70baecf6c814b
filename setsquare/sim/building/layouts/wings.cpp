// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/sim/building/furnishing.hpp"
#include "setsquare/sim/building/layouts/layouts.hpp"
#include "setsquare/sim/building/openings.hpp"
#include "setsquare/sim/building/wing.hpp"

namespace setsquare {
namespace {

/// Directions of the wings: every two that are neighbours turn by 20 to 70 deg against each other,
/// modulo right angles, and leave room between them.
std::vector<double> draw_directions(int num_wings, Random& random) {
  std::vector<double> directions;
  const auto is_odd = [](double from_rad, double to_rad) {
    const double turn = std::abs(wrap_to_period(to_rad - from_rad, 0.5 * kPi));
    const double between = std::abs(wrap_to_pi(to_rad - from_rad));
    return turn >= rad_from_deg(20.0) && between >= rad_from_deg(50.0);
  };
  while (true) {
    directions.assign(1, 0.0);
    while (static_cast<int>(directions.size()) < num_wings)
      directions.push_back(directions.back() + rad_from_deg(random.uniform(50.0, 180.0)));
    if (directions.back() > kTwoPi - rad_from_deg(50.0)) continue;
    bool is_good = is_odd(directions.back(), directions.front());
    for (std::size_t i = 1; i < directions.size(); ++i)
      is_good = is_good && is_odd(directions[i - 1], directions[i]);
    if (is_good) return directions;
  }
}

void append_route(BuildingSketch& sketch, const Wing& in, const Wing& out, Random& random) {
  constexpr double kLongest_m = 78.0;
  const double start_x = in.length_m * random.uniform(0.8, 0.95);
  append_wing_route(sketch, in, start_x, in.rows_from_m, 0.5 * kLongest_m, random);
  sketch.route_m.emplace_back(0.0, 0.0);  // Through the lobby: the corner between may be wall.
  append_wing_route(
      sketch, out, out.rows_from_m, out.length_m * random.uniform(0.8, 0.95), kLongest_m, random);
}

}  // namespace

BuildingSketch sketch_wings(Random& random) {
  BuildingSketch sketch;
  const std::vector<double> directions = draw_directions(random.integer(2, 4), random);
  // The wings meet in a lobby, at least as large as the corridors are wide.
  const double lobby_radius = random.uniform(1.8, 4.5);
  const double lobby_ratio = random.uniform(0.8, 1.25);
  const Pose2 T_map_lobby{0.0, 0.0, random.uniform(-kPi, kPi)};
  const ConvexPolygon lobby =
      ellipse(T_map_lobby, lobby_radius, lobby_ratio * lobby_radius, random.integer(5, 12));
  sketch.spaces.push_back({lobby, {}});
  std::vector<Wing> wings;
  for (const double direction : directions) {
    wings.push_back(make_wing({0.0, 0.0, direction}, random.uniform(14.0, 22.0), random));
    Wing& wing = wings.back();
    wing.rows_from_m = 1.3 * lobby_radius + 0.3;
    const bool is_bare = random.chance(0.25);
    wing.rows.open_share = is_bare ? 0.2 : random.uniform(0.7, 0.95);
    wing.rows.max_width_m = random.uniform(3.8, 6.0);
    add_wing_corridor(sketch, wing, random);
  }
  for (Wing& wing : wings) add_wing_rooms(sketch, wing, random);
  append_route(sketch, wings[0], wings[1], random);
  hang_leaves(sketch, random);
  for (const Wing& wing : wings) furnish_wing(sketch, wing, random);
  const auto seed = static_cast<std::uint64_t>(random.integer(0, 1 << 30));
  furnish(sketch, {lobby, RoomUse::kMeeting, seed, {}});
  return sketch;
}

}  // namespace setsquare
