// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace setsquare {

/// Whether a gyro turns as the scans show that the robot does.
enum class GyroVerdict {
  kOpen,      ///< The robot has not turned enough to tell.
  kBelieved,  ///< It does: its turns predict those of the scans.
  kMirrored,  ///< It turns the other way: its z axis points down.
  kDegrees,   ///< Its rates are degrees per second, whichever way it turns.
  kOffTime,   ///< It does, but earlier or later than the stamps say.
  kUnlike,    ///< It does something else: it stands still, or shows noise.
};

/// "open", "believed", "mirrored", "degrees", "off time", "unlike".
[[nodiscard]] const char* to_string(GyroVerdict verdict);

/// What became of a log's gyro.
struct GyroReport {
  GyroVerdict verdict = GyroVerdict::kOpen;  ///< At the end of the log.
  std::size_t num_samples = 0;               ///< That came.
  std::size_t num_turns = 0;                 ///< By which it was judged.
  double scale = 0.0;                        ///< The scans' turns over the gyro's.
  double scans_late_s = 0.0;    ///< The scans' stamps behind the gyro's, where it is not believed.
  double bias_rad_per_s = 0.0;  ///< What it shows where the robot does not turn, at the end.

  /// Whether it was found to turn the other way than the scans, whatever its unit.
  [[nodiscard]] bool turns_other_way() const {
    return verdict == GyroVerdict::kMirrored || (verdict == GyroVerdict::kDegrees && scale < 0.0);
  }
};

}  // namespace setsquare
