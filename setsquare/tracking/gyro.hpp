// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "setsquare/core/timestamp.hpp"
#include "setsquare/map/gyro_report.hpp"
#include "setsquare/tracking/scan_tracker_params.hpp"

namespace setsquare {

/// Turns from scan to scan by a gyro about the vertical axis, once it has shown that it tells the
/// truth.
///
/// 1. Rates are summed up to an angle, the rate straight between two samples.
/// 2. Stretches of about half a second are compared with the turn that matching of scans found. So
///    long a stretch has the error of its two ends only.
/// 3. The bias is what the gyro shows beyond that turn, the scale the ratio of the turns where the
///    robot does turn: medians over the latest stretches, for single matches may be wrong.
/// 4. Only a gyro whose scale is near 1 is believed. One that is mirrored, in degrees, or shows
///    something else is told and ignored.
class Gyro {
 public:
  explicit Gyro(const GyroParams& params) : params_(params) {}

  /// The next sample. One that is not finite or not later than the last is passed over; a clock
  /// that was set back starts anew.
  void add(Timestamp stamp, double turn_rad_per_s);

  /// How the robot has turned from one scan to the next; nothing where the gyro is not believed, or
  /// its samples do not span the time.
  [[nodiscard]] std::optional<double> turn_rad(Timestamp from, Timestamp to) const;

  /// The turn that matching found between a scan and the next one, which were both placed well.
  void compare(Timestamp from, Timestamp to, double matched_rad);

  [[nodiscard]] const GyroReport& report() const { return report_; }

 private:
  struct Sample {
    Timestamp stamp;
    double rad_per_s = 0.0;
    double angle_rad = 0.0;  ///< Sum of the rates until then.
  };
  /// A stretch of time, and how the robot turned meanwhile by both.
  struct Stretch {
    Timestamp from;
    Timestamp to;
    double matched_rad = 0.0;
    double gyro_rad = 0.0;
    [[nodiscard]] double duration_s() const { return seconds_between(from, to); }
  };

  [[nodiscard]] std::optional<double> angle_rad(Timestamp stamp) const;
  /// As the gyro shows it, bias and scale included.
  [[nodiscard]] std::optional<double> shown_rad(Timestamp from, Timestamp to) const;
  void judge();
  [[nodiscard]] double rest_rad_per_s() const;

  GyroParams params_;
  std::deque<Sample> samples_;  ///< The latest.
  std::optional<Stretch> growing_;
  std::deque<Stretch> stretches_;  ///< The latest.
  GyroReport report_;
};

}  // namespace setsquare
