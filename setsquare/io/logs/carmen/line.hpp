// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "setsquare/io/logs/line_log.hpp"

namespace setsquare {

/// What earlier lines set: PARAM messages hold for the rest of the log.
struct CarmenState {
  LogOptions options;
  std::optional<double> front_max_range_m;  ///< PARAM robot_front_laser_max.
  std::optional<double> rear_max_range_m;   ///< PARAM robot_rear_laser_max.
  /// The unit of the last decimal of the poses in the last scan, in m and rad.
  double pose_rounding = 1.0;
  std::string_view reason;  ///< Why the line is damaged: static text.
};

/// Reads one line of a CARMEN log. Message formats: FLASER, RLASER, RAWLASERn, ROBOTLASERn, ODOM,
/// TRUEPOS, PARAM; other known messages are skipped. The stamp is the IPC stamp, third field
/// from the end. A scan's mounting is robot pose^-1 * laser pose of this line, rounding included.
[[nodiscard]] LineOutcome read_carmen_line(std::string_view line,
                                           CarmenState& state,
                                           LogRecord& record);

/// Whether a text's beginning shows a CARMEN message.
[[nodiscard]] bool is_carmen_log(std::string_view beginning);

}  // namespace setsquare
