// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/sim/plans.hpp"

#include <cmath>
#include <Eigen/LU>

#include "tests/support/seed.hpp"

namespace setsquare::testing {

FloorPlan rectangle_plan(double width_m, double depth_m) {
  FloorPlan plan;
  add_polyline(plan, {{0, 0}, {width_m, 0}, {width_m, depth_m}, {0, depth_m}}, Material::kWall);
  return plan;
}

FloorPlan polygon_plan(int num_corners, double radius_m) {
  std::vector<Eigen::Vector2d> corners_m;
  for (int i = 0; i < num_corners; ++i) {
    corners_m.push_back(radius_m * unit_vector(kTwoPi * i / num_corners));
  }
  FloorPlan plan;
  add_polyline(plan, corners_m, Material::kWall);
  return plan;
}

FloorPlan corridor_plan() {
  FloorPlan plan;
  plan.segments.push_back({{-1000.0, -1.2}, {1000.0, -1.2}});
  plan.segments.push_back({{-1000.0, 1.2}, {1000.0, 1.2}});
  return plan;
}

FloorPlan random_plan(std::mt19937_64& generator,
                      int num_segments,
                      double side_m,
                      const Eigen::Vector2d& middle_m) {
  const auto place = [&] {
    Eigen::Vector2d p_m(uniform(generator, -0.5, 0.5), uniform(generator, -0.5, 0.5));
    p_m *= side_m;
    if (uniform(generator, 0.0, 1.0) < 0.4) p_m = p_m.array().round();
    return Eigen::Vector2d(middle_m + p_m);
  };
  FloorPlan plan;
  for (int i = 0; i < num_segments; ++i) {
    const double lot = uniform(generator, 0.0, 1.0);
    PlanSegment segment{place(), place()};
    if (lot < 0.5) {  // Short ones.
      const double length_m = uniform(generator, 0.05, 3.0);
      segment.end_m = segment.start_m + length_m * unit_vector(uniform(generator, -kPi, kPi));
    }
    if (lot < 0.2) segment.end_m.x() = segment.start_m.x();
    if (lot > 0.2 && lot < 0.4) segment.end_m.y() = segment.start_m.y();
    if (lot > 0.9 && i > 0) segment.start_m = plan.segments.back().end_m;
    if (lot > 0.97) segment.end_m = segment.start_m;
    plan.segments.push_back(segment);
  }
  return plan;
}

FloorPlan moved(const Pose2& T_new_old, const FloorPlan& plan) {
  FloorPlan moved_plan;
  for (const PlanSegment& segment : plan.segments) {
    moved_plan.segments.push_back(
        {T_new_old * segment.start_m, T_new_old * segment.end_m, segment.material});
  }
  return moved_plan;
}

std::optional<RayHit> cast_at_every_segment(const FloorPlan& plan,
                                            const Eigen::Vector2d& origin_m,
                                            const Eigen::Vector2d& direction,
                                            double max_range_m,
                                            double from_m) {
  std::optional<RayHit> nearest;
  for (std::uint32_t i = 0; i < plan.segments.size(); ++i) {
    const PlanSegment& segment = plan.segments[i];
    const Eigen::Vector2d way = segment.end_m - segment.start_m;
    // origin + range * direction = start + share * way.
    Eigen::Matrix2d lines;
    lines << direction, -way;
    const double sine = lines.determinant() / way.norm();
    if (!(std::abs(sine) > 1e-9)) continue;
    const Eigen::Vector2d range_and_share = lines.inverse() * (segment.start_m - origin_m);
    const double range_m = range_and_share.x();
    const double share = range_and_share.y();
    if (share < 0.0 || share > 1.0 || range_m <= from_m || range_m > max_range_m) continue;
    if (!nearest || range_m < nearest->range_m) nearest = {range_m, i, std::abs(sine)};
  }
  return nearest;
}

}  // namespace setsquare::testing
