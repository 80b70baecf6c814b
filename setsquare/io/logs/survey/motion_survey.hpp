// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// How a scan would have to be read so that the odometry's motion explains it.
enum class ScanReading {
  kAsGiven,
  kMirrored,    ///< Left and right exchanged.
  kFieldOf240,  ///< A field of view of 240 degrees instead of 180.
  kFieldOf270,  ///< 270 degrees instead of 180.
  kFieldOf360,  ///< 360 degrees instead of 180.
  kNotMoved,    ///< As given, and the robot stood still, whatever the odometry says.
};
inline constexpr std::size_t kNumScanReadings = 6;

/// The scans of one laser against the odometry that came with them.
///
/// Whenever the odometry has moved by half a metre or 15 degrees, the earlier scan is moved by it
/// and laid over the later one, once for each reading; the reading that fits clearly best has that
/// comparison's vote. While the odometry does not move at all, the scans are compared every tenth
/// scan: the share of ranges that are no longer what they were says whether the robot moved.
class MotionSurvey {
 public:
  void add(const Scan& scan, const Pose2& T_odom_base);

  [[nodiscard]] std::uint64_t num_votes(ScanReading reading) const {
    return num_votes_[static_cast<std::size_t>(reading)];
  }
  /// Comparisons that one reading won clearly.
  [[nodiscard]] std::uint64_t num_decided() const;
  /// Comparisons over a motion of the odometry.
  [[nodiscard]] std::uint64_t num_compared() const { return num_compared_; }
  /// Comparisons while the odometry stood still to the last digit.
  [[nodiscard]] std::uint64_t num_at_rest() const { return num_at_rest_; }
  /// Those of them whose scans differ as only those of a moved robot do.
  [[nodiscard]] std::uint64_t num_moved_at_rest() const { return num_moved_at_rest_; }

 private:
  struct Seen {
    Scan scan;
    Pose2 T_odom_base;
  };

  [[nodiscard]] bool is_to_be_compared();
  void keep(const Scan& scan, const Pose2& T_odom_base);
  void compare(const Scan& scan, const Pose2& T_before_after);
  void compare_at_rest(const Scan& scan);

  std::optional<Seen> reference_;
  std::optional<Pose2> T_odom_last_;
  std::uint64_t num_since_ = 0;  ///< Scans since the reference.
  std::array<std::uint64_t, kNumScanReadings> num_votes_{};
  std::uint64_t num_motions_ = 0;  ///< Of half a metre or 15 degrees.
  std::uint64_t num_compared_ = 0;
  std::uint64_t num_at_rest_ = 0;
  std::uint64_t num_moved_at_rest_ = 0;
};

}  // namespace setsquare
