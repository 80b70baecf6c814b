// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/jolt.hpp"

#include <algorithm>
#include <cmath>

namespace setsquare {
namespace {

/// How far apart two places are, 1 for the least jolt.
double distance_between(const Pose2& a, const Pose2& b, const JoltParams& params) {
  const Pose2 motion = a.inverse() * b;
  return std::hypot(
      motion.x_m / params.min_m, motion.y_m / params.min_m, motion.theta_rad / params.min_rad);
}

}  // namespace

bool is_jolt(const Pose2& expected, const Pose2& place, const JoltParams& params) {
  return distance_between(expected, place, params) > 1.0;
}

bool is_contradicted(const Pose2& expected,
                     const Pose2& place,
                     const Pose2& by_last_scan,
                     const JoltParams& params) {
  return distance_between(expected, by_last_scan, params) <
         std::min(distance_between(expected, place, params),
                  distance_between(by_last_scan, place, params));
}

}  // namespace setsquare
