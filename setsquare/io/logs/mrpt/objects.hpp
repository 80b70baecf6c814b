// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "setsquare/core/pose2.hpp"
#include "setsquare/io/bytes/byte_cursor.hpp"
#include "setsquare/io/logs/log_reader.hpp"
#include "setsquare/io/logs/mrpt/poses.hpp"

namespace setsquare {

// Each of the following reads the body of an object behind its header, end flag excluded. The
// result is empty, or static text that says why the object cannot be read. Whether the block was
// too short shows in bytes.is_short(), whatever the result.

/// CObservation2DRangeScan, versions 0 to 7: fills ranges, geometry, mounting, stamp and sensor.
/// Beams marked invalid become NaN unless they reach the scanner's maximum (a no-return). The
/// mounting is the sensor's pose on the robot seen from above; a scanner mounted upside down sweeps
/// the other way; one tilted by more than 20 degrees gives no scan of the plane.
[[nodiscard]] std::string_view read_mrpt_scan(ByteCursor& bytes, int version, LogRecord& record);

/// CObservationOdometry, versions 0 to 2: an absolute odometry pose.
[[nodiscard]] std::string_view read_mrpt_odometry(ByteCursor& bytes,
                                                  int version,
                                                  LogRecord& record);

/// What CActionRobotMovement2D gives: the motion since the last one, by odometry.
struct MrptMovement {
  Pose2 T_before_after;
  Timestamp stamp;  ///< Zero before version 6.
};

/// CActionRobotMovement2D, versions 2 to 7, as far as it was estimated by odometry.
[[nodiscard]] std::string_view read_mrpt_movement(ByteCursor& bytes,
                                                  int version,
                                                  MrptMovement& movement);

}  // namespace setsquare
