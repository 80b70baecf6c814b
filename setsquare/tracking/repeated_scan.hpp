// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/scan.hpp"
#include "setsquare/tracking/tracked_pose.hpp"

namespace setsquare {

/// Finds scans that a driver hands on a second time: noise and the robot's motion change some range
/// of every new scan. A robot that stands may see the same twice, so the wheels must have moved by
/// a millimetre or a twentieth of a degree since the scan came first: from then on it tells
/// nothing, whether the wheels rest again or not.
class RepeatedScan {
 public:
  /// Whether the scan is the one before again, range by range, and the wheels have moved since that
  /// came first. To be called for every scan.
  [[nodiscard]] bool add(const Scan& scan, const std::optional<Pose2>& T_wheels_base);

  /// Whether the last scan added was the one before again, whatever the wheels did.
  [[nodiscard]] bool is_same() const { return is_same_; }

 private:
  bool is_same_ = false;
  bool has_moved_ = false;  ///< Since a scan came first that is repeated.
  std::vector<double> ranges_m_;
  std::optional<Pose2> T_wheels_base_;
};

/// What is to be said of a scan that is the one before again where no wheels tell how far the robot
/// went: that it is where that was. It tells nothing for or against anything. `answer`: of the scan
/// before.
[[nodiscard]] TrackedPose told_again(TrackedPose answer);

}  // namespace setsquare
