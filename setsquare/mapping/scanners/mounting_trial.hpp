// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/map/mapped_scanner.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/tracking/tracked_pose.hpp"

namespace setsquare {

/// Decides whether a further scanner is where its scans say that it is mounted.
///
/// 1. While the robot moves, tracked by its other scanners, scans of this one are placed in what
///    the others saw (ScanTracker::sight): each gives a mounting.
/// 2. The mounting seen is their median, per coordinate; its standard deviation comes from the
///    median of the deviations, so that a third of the sightings may be wrong.
/// 3. Refuted is a mounting that is off by more than is harmless and more than chance explains.
class MountingTrial {
 public:
  MountingTrial(const MountingTrialParams& params, const Pose2& T_base_sensor);

  /// Whether the robot has moved on since the last scan that was tried, so that the next one adds
  /// to what is known.
  [[nodiscard]] bool wants(const Pose2& T_odom_body) const;

  /// A scan that was tried; nothing where it fits nowhere. `T_odom_body`: where it was expected.
  void add(const Pose2& T_odom_body,
           const Pose2& T_odom_sensor_stated,
           const std::optional<MountingSighting>& sighting);

  /// Verdict, sightings and the mounting seen.
  [[nodiscard]] const MappedScanner& result() const { return result_; }

 private:
  void estimate();
  [[nodiscard]] bool is_off() const;

  MountingTrialParams params_;
  std::optional<Pose2> T_odom_last_;      ///< Of the body, at the last scan that was tried.
  std::vector<double> turned_rad_;        ///< Sightings, each seen from the stated mounting.
  std::vector<Eigen::Vector2d> moved_m_;  ///< Of those that the walls bind.
  std::size_t num_tried_ = 0;
  Pose2 T_stated_seen_;
  MappedScanner result_;
};

}  // namespace setsquare
