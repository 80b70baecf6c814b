// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Geometry>
#include <string>
#include <string_view>
#include <vector>

#include "setsquare/io/logs/survey/range_codes.hpp"
#include "setsquare/io/ros/laser_scan_to_scan.hpp"
#include "setsquare/io/ros/messages.hpp"
#include "setsquare/io/ros/mounting.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// Makes one laser's messages into scans with their mounting, and counts what was odd about them.
class PlacedScans {
 public:
  /// The result is empty, or says why the message is left out. The message's ranges are moved.
  [[nodiscard]] std::string_view place(ros::LaserScan&& message,
                                       const Eigen::Isometry3d& T_base_sensor,
                                       Scan& scan);

  /// What was odd, in which share of the scans, and what was done; one sentence each. Ranges above
  /// range_max are odd where they are measurements; many drivers write a code there for "nothing
  /// seen".
  [[nodiscard]] std::vector<std::string> remarks() const;

 private:
  void count_oddities(ros::ScanOddities oddities, const Scan& scan);

  ros::MountedScans mounted_;
  ros::Mounting mounting_;
  Eigen::Matrix4d T_base_sensor_ = Eigen::Matrix4d::Zero();  ///< Of mounting_.
  RangeCodes codes_beyond_max_;
  std::array<std::uint64_t, ros::kNumScanOddities> num_odd_{};
  std::uint64_t num_scans_ = 0;
};

}  // namespace setsquare
