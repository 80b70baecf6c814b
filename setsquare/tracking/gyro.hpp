// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
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
/// 5. Of one that shows something else the turns of other times are looked at, up to 0.3 s earlier
///    and later, as in logs whose scans are stamped when they arrive: where its turns at one of
///    these times agree best and well enough, it is told what it is, and ignored all the same.
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
  /// Times of the gyro that are compared: as stamped, and earlier and later by these steps.
  static constexpr double kOffsetStep_s = 0.05;
  static constexpr std::size_t kNumOffsets = 13;
  static constexpr std::size_t kNoOffset = kNumOffsets / 2;

  struct Sample {
    Timestamp stamp;
    double rad_per_s = 0.0;
    double angle_rad = 0.0;  ///< Sum of the rates until then.
  };
  /// A stretch of time, and how the robot turned meanwhile by both.
  struct Stretch {
    explicit Stretch(Timestamp begin);

    Timestamp from;
    Timestamp to;
    double matched_rad = 0.0;
    std::array<double, kNumOffsets> gyro_rad;  ///< NaN where its samples do not span the time.
    [[nodiscard]] double duration_s() const { return seconds_between(from, to); }
  };

  [[nodiscard]] std::optional<double> angle_rad(Timestamp stamp) const;
  /// As the gyro shows it, bias and scale included.
  [[nodiscard]] std::optional<double> shown_rad(Timestamp from, Timestamp to) const;
  /// How the gyro's turns at an offset fit the scans'.
  struct Fit {
    std::size_t num_turns = 0;
    double scale = 0.0;
    double deviation = 0.0;  ///< Median, of the single turns' scales.
  };
  [[nodiscard]] Fit fit_at(std::size_t offset) const;
  [[nodiscard]] double rest_rad_per_s(std::size_t offset) const;
  [[nodiscard]] static double scans_late_s(std::size_t offset);
  /// Of a stretch behind which samples have come.
  void show_at_other_times(Stretch& stretch) const;
  void judge();
  void judge_at_other_times();

  GyroParams params_;
  std::deque<Sample> samples_;  ///< The latest.
  std::optional<Stretch> growing_;
  std::deque<Stretch> stretches_;  ///< The latest.
  GyroReport report_;
};

}  // namespace setsquare
