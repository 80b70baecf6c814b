// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from scan_tracker, its only caller, because tests drive it without scans.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// Where the next scan is expected, from the odometry if there is any, else from the last motion.
///
/// The last motion is counted in scans, not in seconds: scanners sweep evenly, while the stamps of
/// real logs jitter and run backwards. The translation is the mean of several scans (a corridor
/// leaves it undetermined in single ones), the rotation that of the last scan (robots start turning
/// at once).
class MotionPrediction {
 public:
  explicit MotionPrediction(std::size_t num_scans_averaged)
      : num_scans_averaged_(num_scans_averaged) {}

  /// The pose that tracking gave, and the odometry's pose of the sensor at the same scan.
  void add(const Pose2& T_odom_sensor, const std::optional<Pose2>& T_wheels_sensor);

  /// The expected pose of the next scan. Not to be called before the first add().
  [[nodiscard]] Pose2 next(const std::optional<Pose2>& T_wheels_sensor) const;

  /// Whether next() is the odometry's.
  [[nodiscard]] bool has_odometry(const std::optional<Pose2>& T_wheels_sensor) const {
    return T_wheels_sensor && T_wheels_sensor_;
  }

  /// Forgets the motion before the last pose: it was not observed.
  void restart();

 private:
  [[nodiscard]] Pose2 next_by_last_motion() const;

  std::size_t num_scans_averaged_;
  std::deque<Pose2> poses_;  ///< T_odom_sensor of the last scans, the newest at the back.
  std::optional<Pose2> T_wheels_sensor_;
};

}  // namespace setsquare
