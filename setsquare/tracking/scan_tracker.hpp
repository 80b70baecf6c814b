// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "setsquare/scan/scan.hpp"
#include "setsquare/tracking/keyframe.hpp"
#include "setsquare/tracking/motion_prediction.hpp"
#include "setsquare/tracking/scan_gap.hpp"
#include "setsquare/tracking/scan_tracker_params.hpp"
#include "setsquare/tracking/submap_refinement.hpp"
#include "setsquare/tracking/tracked_pose.hpp"

namespace setsquare {

/// Places scan after scan against a submap of the latest keyframes.
///
/// 1. Predict: from the odometry if there is any, else from the last motion.
/// 2. Refine: Gauss-Newton, point to line, against the surfaces of every keyframe of the submap.
/// 3. Recover where the scan does not fit, or where the log has a gap that no odometry bridges: the
///    guess-free matcher, anywhere and at any turn. After a gap no other answer counts.
/// 4. Search along the corridor where the walls leave a direction free.
/// 5. Keep the scan as a keyframe where it is far enough from the last one.
class ScanTracker {
 public:
  explicit ScanTracker(const ScanTrackerParams& params = {});

  /// Places the next scan. `T_wheels_sensor` is the pose of the sensor by wheel odometry, in any
  /// frame that stays put. The first scan stands at the identity. A scan with fewer than min_points
  /// returns is lost, at the predicted pose, and leaves the submap as it was; until one has more,
  /// there is no submap.
  TrackedPose track(const Scan& scan, const std::optional<Pose2>& T_wheels_sensor);

  /// The scans kept that the next one is compared with, the latest at the back.
  [[nodiscard]] const std::vector<KeyframePtr>& submap() const { return submap_; }

 private:
  /// What is known of a scan before it is placed.
  enum class Situation {
    kSeesTooLittle,  ///< Fewer than min_points returns: lost; the submap stays as it is.
    kNoSubmap,       ///< Nothing to place it against: it begins a submap where it is predicted.
    kExpected,       ///< Near the predicted pose, but for a slip of tracking.
    kAnywhere,       ///< A gap in the log, and no odometry: it may be anywhere.
  };
  class ArrivedScan;

  [[nodiscard]] Situation situation_of(std::size_t num_points, bool is_behind_gap) const;
  TrackedPose place_expected(ArrivedScan& scan, const Pose2& predicted, bool has_odometry);
  TrackedPose place_anywhere(ArrivedScan& scan, const Pose2& predicted);
  /// A fit as an answer: lost where it is poor, searched along the corridor where one is open.
  TrackedPose judged(const TrackingProblem& problem, SubmapFit fit, bool is_recovered);
  /// Whether a direction is open.
  [[nodiscard]] bool is_open(const SubmapFit& fit) const;
  /// Counts scans that are lost in a row. A scan that sees next to nothing is no evidence against
  /// the submap.
  void count_lost(TrackStatus status, Situation situation);
  /// Whether the submap restarts with the scan that was counted last.
  [[nodiscard]] bool is_restart(Situation situation) const;
  void start_anew();
  [[nodiscard]] bool is_to_be_kept(const TrackedPose& tracked) const;
  void keep(const Scan& scan, ScanSurfacesPtr surfaces, const Pose2& T_odom_sensor);

  ScanTrackerParams params_;
  MotionPrediction motion_;
  ScanGap gap_;
  std::vector<KeyframePtr> submap_;
  std::vector<PlacedImage> submap_images_;  ///< Of the same keyframes.
  PointMarks marks_;
  std::size_t num_scans_ = 0;
  std::size_t num_lost_ = 0;  ///< In a row, of the scans that see enough.
};

}  // namespace setsquare
