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

/// A round room and how far it reaches to any side.
struct RoundRoom {
  Eigen::Vector2d center_m;
  double inner_radius_m;  ///< Inside of all sides.
  double outer_radius_m;
  Room room;
  Eigen::Vector2d way_on_m = center_m;  ///< The bend of the passage to the next room.
};

/// A circle, an ellipse, or an irregular polygon: uneven corners on an ellipse.
RoundRoom draw_round_room(const Eigen::Vector2d& center_m, double radius_m, Random& random) {
  const double ratio = random.chance(0.35) ? 1.0 : random.uniform(0.7, 1.0);
  const Pose2 T_map_center{center_m.x(), center_m.y(), random.uniform(-kPi, kPi)};
  ConvexPolygon outline;
  if (random.chance(0.55)) {
    outline = ellipse(T_map_center, radius_m, ratio * radius_m, 48);
  } else {
    const int num_corners = random.integer(5, 9);
    for (int i = 0; i < num_corners; ++i) {
      const double angle = kTwoPi * (i + random.uniform(-0.3, 0.3)) / num_corners;
      outline.push_back(T_map_center * Eigen::Vector2d(radius_m * std::cos(angle),
                                                       ratio * radius_m * std::sin(angle)));
    }
  }
  const auto seed = static_cast<std::uint64_t>(random.integer(0, 1 << 30));
  RoundRoom round{center_m, radius_m, radius_m, {outline, RoomUse::kRound, seed, {}}, center_m};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d side = (outline[(i + 1) % outline.size()] - outline[i]).normalized();
    const Eigen::Vector2d spoke = outline[i] - center_m;
    const double depth = std::abs(side.x() * spoke.y() - side.y() * spoke.x());
    round.inner_radius_m = std::min(round.inner_radius_m, depth);
  }
  return round;
}

/// A straight piece of a passage. What of it lies in rooms vanishes in them.
void add_passage(BuildingSketch& sketch,
                 const Eigen::Vector2d& from_m,
                 const Eigen::Vector2d& to_m,
                 double half_width_m) {
  const Eigen::Vector2d way = to_m - from_m;
  const Pose2 T_map_passage{from_m.x(), from_m.y(), std::atan2(way.y(), way.x())};
  sketch.spaces.push_back(
      {rectangle(T_map_passage, 0.0, -half_width_m, way.norm(), half_width_m), {}});
  sketch.kept_free.push_back(rectangle(T_map_passage, 0.0, -0.4, way.norm(), 0.4));
}

/// A passage from a room to the next one with a bend in it; returns where it bends.
Eigen::Vector2d add_bent_passage(BuildingSketch& sketch,
                                 const RoundRoom& from,
                                 const RoundRoom& to,
                                 Random& random) {
  const Eigen::Vector2d way = (to.center_m - from.center_m).normalized();
  const double gap = (to.center_m - from.center_m).norm() - from.outer_radius_m - to.outer_radius_m;
  const double side = random.chance(0.5) ? 1.0 : -1.0;
  const Eigen::Vector2d bend = from.center_m + (from.outer_radius_m + 0.5 * gap) * way +
                               side * random.uniform(0.6, 1.8) * Eigen::Vector2d(-way.y(), way.x());
  const double half_width = random.uniform(0.45, 0.65);
  add_passage(sketch, from.center_m, bend, half_width);
  add_passage(sketch, bend, to.center_m, half_width);
  const double radius = 1.1 * half_width;
  sketch.spaces.push_back({ellipse({bend.x(), bend.y(), 0.0}, radius, radius, 9), {}});
  return bend;
}

/// Rooms in a chain, each next to the one before; rooms without a place are left out.
std::vector<RoundRoom> add_chain(BuildingSketch& sketch, Random& random) {
  constexpr int kTries = 200;
  std::vector<RoundRoom> chain{draw_round_room({0.0, 0.0}, random.uniform(1.8, 4.5), random)};
  sketch.spaces.push_back({chain[0].room.outline, {}});
  const int num_rooms = random.integer(6, 8);
  for (int i = 0; i < kTries && static_cast<int>(chain.size()) < num_rooms; ++i) {
    const double radius = random.chance(0.12) ? 5.5 : random.uniform(1.8, 3.5);
    const double gap = random.uniform(1.2, 4.0);
    const double direction = random.uniform(-kPi, kPi);
    const RoundRoom& last = chain.back();
    const double distance = last.outer_radius_m + radius + gap;
    const Eigen::Vector2d center =
        last.center_m + distance * Eigen::Vector2d(std::cos(direction), std::sin(direction));
    const RoundRoom next = draw_round_room(center, radius, random);
    if (!is_unbuilt(sketch, next.room.outline, 0.2)) continue;
    chain.back().way_on_m = add_bent_passage(sketch, last, next, random);
    sketch.spaces.push_back({next.room.outline, {}});
    chain.push_back(next);
  }
  return chain;
}

/// One or two stops in a room and back to its centre, where it is large enough.
void add_detour(BuildingSketch& sketch, const RoundRoom& room, Random& random) {
  const double reach = room.inner_radius_m - 1.1;
  if (reach < 0.8) return;
  const int num_stops = random.integer(0, 2);
  double direction = random.uniform(-kPi, kPi);
  for (int i = 0; i < num_stops; ++i) {
    const double radius = random.uniform(0.6, 1.0) * reach;
    sketch.route_m.push_back(room.center_m +
                             radius * Eigen::Vector2d(std::cos(direction), std::sin(direction)));
    direction += random.uniform(0.8, 2.2);
  }
  if (num_stops > 0) sketch.route_m.push_back(room.center_m);
}

/// From room to room by the centres, with a detour in most of them.
void add_route(BuildingSketch& sketch, const std::vector<RoundRoom>& chain, Random& random) {
  for (const RoundRoom& room : chain) {
    sketch.route_m.push_back(room.center_m);
    add_detour(sketch, room, random);
    if (&room != &chain.back()) sketch.route_m.push_back(room.way_on_m);
  }
}

/// Closed doors, windows and niches in the straight sides.
void add_recesses(BuildingSketch& sketch, const RoundRoom& room, Random& random) {
  const ConvexPolygon& outline = room.room.outline;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d side = outline[(i + 1) % outline.size()] - outline[i];
    const double width = random.uniform(0.8, 1.6);
    const double share = random.uniform(0.3, 0.7);
    if (side.norm() < 2.2 || random.chance(0.4)) continue;
    const Eigen::Vector2d middle = outline[i] + share * side;
    const Pose2 place{middle.x(), middle.y(), std::atan2(side.y(), side.x()) - 0.5 * kPi};
    if (!is_unbuilt(sketch, rectangle(place, 0.05, -0.5 * width, 0.6, 0.5 * width), 0.04)) continue;
    const double depth = random.uniform(0.08, 0.4);
    const double kind = random.uniform();
    if (kind < 0.4)
      add_closed_door(sketch, place, std::min(width, 1.0), 0.5 * depth);
    else if (kind < 0.7)
      add_window(sketch, place, width, 0.5 * depth);
    else
      add_niche(sketch, place, width, depth);
  }
}

}  // namespace

BuildingSketch sketch_round(Random& random) {
  BuildingSketch sketch;
  const std::vector<RoundRoom> chain = add_chain(sketch, random);
  for (const RoundRoom& room : chain) add_recesses(sketch, room, random);
  add_route(sketch, chain, random);
  for (const RoundRoom& room : chain) furnish(sketch, room.room);
  for (const RoundRoom& room : chain)
    add_people(sketch, room.room.outline, random.integer(0, 2), 0.5, random);
  return sketch;
}

}  // namespace setsquare
