// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "setsquare/scan/match_result.hpp"

namespace setsquare {

/// The information of a relative pose of two sensors, (x, y, theta) in the first one's frame, as
/// that of the relative pose of the robots, in the first robot's frame.
[[nodiscard]] Eigen::Matrix3d information_of_base(const Eigen::Matrix3d& of_sensor,
                                                  const Pose2& T_sensor_sensor,
                                                  const Pose2& T_base_sensor_reference,
                                                  const Pose2& T_base_sensor_current);

/// The same answer for the robot's poses: T_base_base from T_sensor_sensor by the scans' mountings
/// (Scan::T_base_sensor), with the information and the degenerate direction in the reference
/// robot's frame.
[[nodiscard]] MatchResult match_result_of_base(const MatchResult& of_sensor,
                                               const Pose2& T_base_sensor_reference,
                                               const Pose2& T_base_sensor_current);

}  // namespace setsquare
