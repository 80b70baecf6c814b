// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from scan_tracker, its only caller, because tests drive it without scans.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"

namespace setsquare {

/// When one of the robot's scanners began a sweep.
struct SweepStart {
  std::uint32_t scanner = 0;  ///< Scan::scanner
  Timestamp stamp;
};

/// Where the robot's body is expected at the next scan, from the odometry if there is any, else
/// from the last motion.
///
/// The last motion is counted in scans, not in seconds: scanners sweep evenly, while the stamps of
/// real logs jitter and run backwards. The translation is the mean of several scans (a corridor
/// leaves it undetermined in single ones), the rotation that of the last scan (robots start turning
/// at once). Scans of another scanner come in between, at any time: to those the motion goes on by
/// the share of the last scanner's period that the stamps tell. Where a gyro tells the rotation, it
/// takes the place of the last one.
class MotionPrediction {
 public:
  explicit MotionPrediction(std::size_t num_scans_averaged)
      : num_scans_averaged_(num_scans_averaged) {}

  /// The pose that tracking gave, and the odometry's pose of the body at the same scan.
  void add(const Pose2& T_odom_body,
           const std::optional<Pose2>& T_wheels_body,
           const SweepStart& sweep = {});

  /// The expected pose of the next scan. `gyro_turn_rad`: since the last scan, where it is known.
  /// Not to be called before the first add().
  [[nodiscard]] Pose2 next(const std::optional<Pose2>& T_wheels_body,
                           const SweepStart& sweep = {},
                           std::optional<double> gyro_turn_rad = std::nullopt) const;

  /// Whether next() is the odometry's.
  [[nodiscard]] bool has_odometry(const std::optional<Pose2>& T_wheels_body) const {
    return T_wheels_body && T_wheels_body_;
  }

  /// Forgets the motion before the last pose: it was not observed.
  void restart();

 private:
  /// What one scanner's scans have seen of the motion.
  struct Seen {
    std::deque<Pose2> poses;  ///< T_odom_body at its last scans, the newest at the back.
    Timestamp stamp;          ///< Of the newest,
    double period_s = 0.0;    ///< and from the one before to it.
  };

  [[nodiscard]] const Seen& last() const { return seen_.at(last_scanner_); }
  [[nodiscard]] double share_of_period(const SweepStart& sweep) const;
  [[nodiscard]] Pose2 next_by_last_motion(double share_of_period,
                                          std::optional<double> gyro_turn_rad) const;

  std::size_t num_scans_averaged_;
  std::map<std::uint32_t, Seen> seen_;  ///< By scanner.
  std::uint32_t last_scanner_ = 0;
  std::optional<Pose2> T_wheels_body_;
};

}  // namespace setsquare
