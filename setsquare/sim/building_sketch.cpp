// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/building_sketch.hpp"

#include <algorithm>
#include <cstddef>

namespace setsquare {
namespace {

struct Bounds {
  Eigen::Array2d low_m;
  Eigen::Array2d high_m;
};

Bounds bounds_of(const ConvexPolygon& polygon) {
  Bounds bounds{polygon.front(), polygon.front()};
  for (const Eigen::Vector2d& corner : polygon) {
    bounds.low_m = bounds.low_m.min(corner.array());
    bounds.high_m = bounds.high_m.max(corner.array());
  }
  return bounds;
}

/// Appends what is left of a side after the given parts of it are taken out.
void add_remainder(const PlanSegment& side,
                   std::vector<InsideInterval>& taken,
                   std::vector<PlanSegment>& segments) {
  constexpr double kShortest_m = 1e-4;
  const auto earlier = [](const InsideInterval& a, const InsideInterval& b) {
    return a.first < b.first;
  };
  std::sort(taken.begin(), taken.end(), earlier);
  taken.push_back({1.0, 1.0});
  const Eigen::Vector2d along = side.end_m - side.start_m;
  double reached = 0.0;
  for (const InsideInterval& part : taken) {
    if ((part.first - reached) * along.norm() > kShortest_m)
      segments.push_back(
          {side.start_m + reached * along, side.start_m + part.first * along, side.material});
    reached = std::max(reached, part.second);
  }
}

}  // namespace

std::vector<PlanSegment> wall_segments(const std::vector<Space>& spaces) {
  std::vector<Bounds> bounds;
  for (const Space& space : spaces) bounds.push_back(bounds_of(space.outline));
  std::vector<PlanSegment> segments;
  std::vector<std::size_t> near;
  std::vector<InsideInterval> taken;
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    near.clear();
    for (std::size_t j = 0; j < spaces.size(); ++j)
      if (j != i && (bounds[j].low_m < bounds[i].high_m).all() &&
          (bounds[i].low_m < bounds[j].high_m).all())
        near.push_back(j);
    const ConvexPolygon& outline = spaces[i].outline;
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Material material = spaces[i].sides.empty() ? Material::kWall : spaces[i].sides[k];
      const PlanSegment side{outline[k], outline[(k + 1) % outline.size()], material};
      taken.clear();
      for (const std::size_t j : near) {
        const InsideInterval part = inside_interval(spaces[j].outline, side.start_m, side.end_m);
        if (!part.is_empty()) taken.push_back(part);
      }
      add_remainder(side, taken, segments);
    }
  }
  return segments;
}

bool is_unbuilt(const BuildingSketch& sketch, const ConvexPolygon& outline, double gap_m) {
  return std::all_of(sketch.spaces.begin(), sketch.spaces.end(), [&](const Space& space) {
    return are_apart(space.outline, outline, gap_m);
  });
}

void add_outline(BuildingSketch& sketch, const ConvexPolygon& outline, Material material) {
  for (std::size_t i = 0; i < outline.size(); ++i)
    sketch.fittings.push_back({outline[i], outline[(i + 1) % outline.size()], material});
}

Building finish(const BuildingSketch& sketch, double rotation_rad) {
  const Pose2 turn{0.0, 0.0, rotation_rad};
  Building building;
  building.plan.segments = wall_segments(sketch.spaces);
  building.plan.segments.insert(
      building.plan.segments.end(), sketch.fittings.begin(), sketch.fittings.end());
  for (PlanSegment& segment : building.plan.segments) {
    segment.start_m = turn * segment.start_m;
    segment.end_m = turn * segment.end_m;
  }
  building.people = sketch.people;
  for (Person& person : building.people) {
    person.from_m = turn * person.from_m;
    person.to_m = turn * person.to_m;
  }
  for (const Eigen::Vector2d& point : sketch.route_m) building.route_m.push_back(turn * point);
  return building;
}

}  // namespace setsquare
