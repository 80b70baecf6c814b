// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/building/sketch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "setsquare/core/angle.hpp"

namespace setsquare {
namespace {

/// Whether one of the sides of `a` parts the two by the gap.
bool has_parting_side(const ConvexPolygon& a, const ConvexPolygon& b, double gap_m) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Eigen::Vector2d side = a[(i + 1) % a.size()] - a[i];
    const double threshold = gap_m * side.norm();
    const bool is_parting = std::all_of(b.begin(), b.end(), [&](const Eigen::Vector2d& corner) {
      return -cross(side, corner - a[i]) >= threshold;
    });
    if (is_parting) return true;
  }
  return false;
}

bool are_bounds_apart(const ConvexPolygon& a, const ConvexPolygon& b, double gap_m) {
  Eigen::Array2d low_a = a.front(), high_a = low_a, low_b = b.front(), high_b = low_b;
  for (const Eigen::Vector2d& corner : a) {
    low_a = low_a.min(corner.array());
    high_a = high_a.max(corner.array());
  }
  for (const Eigen::Vector2d& corner : b) {
    low_b = low_b.min(corner.array());
    high_b = high_b.max(corner.array());
  }
  return (low_a - high_b >= gap_m).any() || (low_b - high_a >= gap_m).any();
}

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

ConvexPolygon rectangle(
    const Pose2& T_map_frame, double x0_m, double y0_m, double x1_m, double y1_m) {
  return {T_map_frame * Eigen::Vector2d(x0_m, y0_m),
          T_map_frame * Eigen::Vector2d(x1_m, y0_m),
          T_map_frame * Eigen::Vector2d(x1_m, y1_m),
          T_map_frame * Eigen::Vector2d(x0_m, y1_m)};
}

ConvexPolygon box(const Pose2& T_map_center, double length_m, double width_m) {
  const double x = 0.5 * length_m;
  const double y = 0.5 * width_m;
  return rectangle(T_map_center, -x, -y, x, y);
}

ConvexPolygon ellipse(const Pose2& T_map_center,
                      double radius_x_m,
                      double radius_y_m,
                      int num_corners) {
  ConvexPolygon corners;
  for (int i = 0; i < num_corners; ++i) {
    const double angle = kTwoPi * i / num_corners;
    corners.push_back(T_map_center *
                      Eigen::Vector2d(radius_x_m * std::cos(angle), radius_y_m * std::sin(angle)));
  }
  return corners;
}

bool contains(const ConvexPolygon& polygon, const Eigen::Vector2d& point_m, double margin_m) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d side = polygon[(i + 1) % polygon.size()] - polygon[i];
    if (cross(side, point_m - polygon[i]) < margin_m * side.norm()) return false;
  }
  return true;
}

bool contains(const ConvexPolygon& outer, const ConvexPolygon& inner) {
  return std::all_of(inner.begin(), inner.end(), [&outer](const Eigen::Vector2d& corner) {
    return contains(outer, corner);
  });
}

bool are_apart(const ConvexPolygon& a, const ConvexPolygon& b, double gap_m) {
  return are_bounds_apart(a, b, gap_m) || has_parting_side(a, b, gap_m) ||
         has_parting_side(b, a, gap_m);
}

InsideInterval inside_interval(const ConvexPolygon& polygon,
                               const Eigen::Vector2d& start_m,
                               const Eigen::Vector2d& end_m) {
  constexpr double kOnSide_m = 1e-6;  // A line this near to a side is not inside.
  InsideInterval inside{0.0, 1.0};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d side = (polygon[(i + 1) % polygon.size()] - polygon[i]).normalized();
    const double depth_start = cross(side, start_m - polygon[i]) - kOnSide_m;
    const double depth_end = cross(side, end_m - polygon[i]) - kOnSide_m;
    if (depth_start <= 0.0 && depth_end <= 0.0) return {};
    const double crossing = depth_start / (depth_start - depth_end);
    if (depth_start <= 0.0) inside.first = std::max(inside.first, crossing);
    if (depth_end <= 0.0) inside.second = std::min(inside.second, crossing);
  }
  return inside;
}

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
