// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "setsquare/scan/scan.hpp"
#include "setsquare/tracking/repeated_scan.hpp"
#include "setsquare/tracking/scan_tracker.hpp"

namespace setsquare {

/// Whether a scanner sees all around: one that spins, whose sweep takes the time from scan to scan.
[[nodiscard]] bool sees_all_around(const Scan& scan);

/// Finds how long a scanner that spins takes for a sweep, and which way it spins, from what the
/// walls show while the robot turns. For logs that do not state it (most cheap scanners' drivers,
/// CARMEN logs), or state it wrongly.
///
/// 1. A tracker of its own places each scan and finds how the robot turned during the sweep, with
///    nothing expected (refined_turns): the scans before the turn were not skewed.
/// 2. From the middle of a sweep to the middle of the next one the robot turns as it did in the
///    second half of the one and the first half of the other, if sweeps follow each other without a
///    pause. The ratio of the two is the share of the time from scan to scan that a sweep takes;
///    negative where the beams run the other way.
/// 3. The median over the steps of turns decides, once its standard error is small.
class SweepTrial {
 public:
  explicit SweepTrial(const ScanTrackerParams& params);

  /// The next scan of the scanner.
  void add(const Scan& scan, const std::optional<Pose2>& T_wheels_base);

  /// From the first beam to the last, in s, once it is known; 0: all are measured at once.
  [[nodiscard]] const std::optional<double>& sweep_s() const { return sweep_s_; }
  [[nodiscard]] std::size_t num_turns() const { return shares_.size(); }
  /// Whether more scans may tell.
  [[nodiscard]] bool is_open() const { return !sweep_s_ && num_scans_ < params_.max_scans; }

 private:
  /// A scan placed, and how the robot turned meanwhile.
  struct Observed {
    bool is_tracked = false;
    double heading_rad = 0.0;
    SweepMotion motion;
  };

  void compare(const Observed& last, const Observed& now);
  void judge(std::size_t num_beams);

  SweepTrialParams params_;
  ScanTracker tracker_;
  RepeatedScan repeated_;
  std::optional<Timestamp> last_stamp_;
  std::size_t num_scans_ = 0;
  Observed last_;
  std::vector<double> shares_;  ///< Of the time from scan to scan.
  std::vector<double> periods_s_;
  std::optional<double> sweep_s_;
};

}  // namespace setsquare
