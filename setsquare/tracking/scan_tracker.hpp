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
  TrackedPose place(const Scan& scan,
                    const SurfaceSamples& points,
                    const Pose2& predicted,
                    bool has_odometry,
                    bool is_anywhere);
  /// Whether a direction is open.
  [[nodiscard]] bool is_weak(const SubmapFit& fit) const;
  void start_anew();
  void keep_if_far(const Scan& scan, SurfacePoints points, TrackedPose& tracked);

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
