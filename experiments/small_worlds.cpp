// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/small_worlds.hpp"

#include <cmath>

#include "setsquare/core/pose2.hpp"
#include "setsquare/sim/random.hpp"

namespace setsquare::experiments {
namespace {

using Corners = std::vector<Eigen::Vector2d>;

Corners regular_polygon(const Eigen::Vector2d& centre_m, double radius_m, int num_corners) {
  Corners corners_m;
  for (int i = 0; i < num_corners; ++i) {
    const double angle_rad = kTwoPi * i / num_corners;
    corners_m.emplace_back(centre_m.x() + radius_m * std::cos(angle_rad),
                           centre_m.y() + radius_m * std::sin(angle_rad));
  }
  return corners_m;
}

/// Longer than the scanner reaches from anywhere on the route.
constexpr double kHalfCorridor_m = 60.0;

void build_corridor(Building& world, Random& random) {
  const double half_m = random.uniform(0.9, 2.0);
  for (const double y_m : {-half_m, half_m}) {
    add_polyline(
        world.plan, {{-kHalfCorridor_m, y_m}, {kHalfCorridor_m, y_m}}, Material::kWall, false);
  }
  const double aside_m = random.uniform(-0.3, 0.3) * half_m;
  world.route_m = {{-3.0, aside_m}, {0.0, -aside_m}, {4.0, aside_m}};
}

void build_niches(Building& world, Random& random) {
  const double half_m = random.uniform(0.9, 1.5);
  const double depth_m = random.uniform(0.2, 0.5);
  const double width_m = random.uniform(0.6, 1.2);
  for (const double side : {-1.0, 1.0}) {
    Corners corners_m;
    for (double x_m = -kHalfCorridor_m; x_m < kHalfCorridor_m; x_m += 2.0) {
      corners_m.emplace_back(x_m, side * half_m);
      corners_m.emplace_back(x_m, side * (half_m + depth_m));
      corners_m.emplace_back(x_m + width_m, side * (half_m + depth_m));
      corners_m.emplace_back(x_m + width_m, side * half_m);
    }
    add_polyline(world.plan, corners_m, Material::kWall, false);
  }
  world.route_m = {{-3.0, 0.1}, {0.0, -0.1}, {4.0, 0.1}};
}

void build_room(Building& world, Random& random, Material material) {
  const Eigen::Vector2d half_m(random.uniform(2.5, 5.0), random.uniform(2.5, 5.0));
  const Corners corners_m = {{-half_m.x(), -half_m.y()},
                             {half_m.x(), -half_m.y()},
                             {half_m.x(), half_m.y()},
                             {-half_m.x(), half_m.y()}};
  add_polyline(world.plan, corners_m, material);
  if (material == Material::kGlass) {
    for (const Eigen::Vector2d& corner_m : corners_m) {
      add_polyline(world.plan, regular_polygon(corner_m, 0.06, 6), Material::kPillar);
    }
  }
  world.route_m = {{-0.6 * half_m.x(), -0.5 * half_m.y()},
                   {0.5 * half_m.x(), -0.4 * half_m.y()},
                   {0.5 * half_m.x(), 0.6 * half_m.y()}};
}

void build_round_hall(Building& world, Random& random) {
  const double radius_m = random.uniform(3.0, 8.0);
  add_polyline(world.plan, regular_polygon({0.0, 0.0}, radius_m, 360), Material::kWall);
  world.route_m = {{-0.5 * radius_m, -0.3 * radius_m},
                   {0.4 * radius_m, -0.2 * radius_m},
                   {0.2 * radius_m, 0.5 * radius_m}};
}

void build_field(Building& world, Random& random) {
  const int num_posts = random.integer(0, 2);
  for (int i = 0; i < num_posts; ++i) {
    const Eigen::Vector2d place_m(random.uniform(-9.0, 9.0), random.uniform(4.0, 12.0));
    add_polyline(world.plan, regular_polygon(place_m, 0.1, 8), Material::kPillar);
  }
  world.route_m = {{-3.0, 0.0}, {1.0, 0.2}, {3.0, -1.0}};
}

void turn(Building& world, double angle_rad) {
  const Pose2 turned{0.0, 0.0, angle_rad};
  for (PlanSegment& segment : world.plan.segments) {
    segment.start_m = turned * segment.start_m;
    segment.end_m = turned * segment.end_m;
  }
  for (Eigen::Vector2d& corner_m : world.route_m) corner_m = turned * corner_m;
}

}  // namespace

SmallWorldWords words_of(SmallWorld world) {
  switch (world) {
    case SmallWorld::kBareCorridor:
      return {"bare corridor", "open along the corridor"};
    case SmallWorld::kSymmetricRoom:
      return {"symmetric room", "looks the same after a half turn"};
    case SmallWorld::kRoundHall:
      return {"round hall", "looks the same after any turn about its centre"};
    case SmallWorld::kOpenField:
      return {"open field", "nothing, or one or two posts"};
    case SmallWorld::kGlassWalls:
      return {"glass walls", "seen at right angles only, else seen through"};
    case SmallWorld::kNiches:
      return {"niches every 2 m", "looks the same after every 2 m"};
  }
  return {};
}

Building make_small_world(SmallWorld world, std::uint64_t seed) {
  Random random(sub_seed(seed, 500 + static_cast<std::uint64_t>(world)));
  Building building;
  switch (world) {
    case SmallWorld::kBareCorridor:
      build_corridor(building, random);
      break;
    case SmallWorld::kSymmetricRoom:
      build_room(building, random, Material::kWall);
      break;
    case SmallWorld::kRoundHall:
      build_round_hall(building, random);
      break;
    case SmallWorld::kOpenField:
      build_field(building, random);
      break;
    case SmallWorld::kGlassWalls:
      build_room(building, random, Material::kGlass);
      break;
    case SmallWorld::kNiches:
      build_niches(building, random);
      break;
  }
  turn(building, random.uniform(-kPi, kPi));
  return building;
}

}  // namespace setsquare::experiments
