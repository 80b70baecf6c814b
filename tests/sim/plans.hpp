// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <random>

#include "setsquare/core/pose2.hpp"
#include "setsquare/sim/floor_plan.hpp"
#include "setsquare/sim/sensing/ray_casting.hpp"

namespace setsquare::testing {

/// A rectangle of walls with corners (0, 0) and (width, depth).
[[nodiscard]] FloorPlan rectangle_plan(double width_m, double depth_m);

/// A regular polygon about the origin; of many corners: a round hall.
[[nodiscard]] FloorPlan polygon_plan(int num_corners, double radius_m);

/// Two walls along x at y = -1.2 and y = 1.2, from -1 km to 1 km.
[[nodiscard]] FloorPlan corridor_plan();

/// Segments of all lengths and directions in a square of `side_m` about `middle_m`: many along the
/// axes and on round coordinates, some that share corners, some of no length.
[[nodiscard]] FloorPlan random_plan(std::mt19937_64& generator,
                                    int num_segments,
                                    double side_m,
                                    const Eigen::Vector2d& middle_m = Eigen::Vector2d::Zero());

[[nodiscard]] FloorPlan moved(const Pose2& T_new_old, const FloorPlan& plan);

/// The plain twin of RayCaster::cast: every segment is tried, its line and the ray solved as two
/// equations.
[[nodiscard]] std::optional<RayHit> cast_at_every_segment(const FloorPlan& plan,
                                                          const Eigen::Vector2d& origin_m,
                                                          const Eigen::Vector2d& direction,
                                                          double max_range_m,
                                                          double from_m = 0.0);

[[nodiscard]] inline Eigen::Vector2d unit_vector(double angle_rad) {
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

}  // namespace setsquare::testing
