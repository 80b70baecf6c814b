// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>

#include <cmath>
#include <ostream>

#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// Found by GoogleTest when it prints a pose.
inline void PrintTo(const Pose2& pose, std::ostream* out) {
  *out << "(" << pose.x_m << " m, " << pose.y_m << " m, " << deg_from_rad(pose.theta_rad)
       << " deg)";
}

}  // namespace setsquare

namespace setsquare::testing {

struct PoseTolerance {
  double translation_m = 1e-9;
  double rotation_rad = 1e-9;
};

/// EXPECT_THAT(T, PoseNear(expected, {.translation_m = 0.01, .rotation_rad = 0.001}))
MATCHER_P2(PoseNear, expected, tolerance, "") {
  const double distance_m = std::hypot(arg.x_m - expected.x_m, arg.y_m - expected.y_m);
  const double rotation_rad = std::abs(wrap_to_pi(arg.theta_rad - expected.theta_rad));
  *result_listener << "which is " << distance_m << " m and " << deg_from_rad(rotation_rad)
                   << " deg away from (" << expected.x_m << " m, " << expected.y_m << " m, "
                   << deg_from_rad(expected.theta_rad) << " deg)";
  return distance_m <= tolerance.translation_m && rotation_rad <= tolerance.rotation_rad;
}

}  // namespace setsquare::testing
