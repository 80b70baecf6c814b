// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/scan_tracker.hpp"

#include <cmath>
#include <memory>
#include <utility>

#include "setsquare/tracking/recovery.hpp"
#include "setsquare/tracking/submap_refinement.hpp"

namespace setsquare {

ScanTracker::ScanTracker(const ScanTrackerParams& params)
    : params_(params), motion_(params.num_scans_averaged), gap_(params.gap) {
  params_.validate();
}

TrackedPose ScanTracker::track(const Scan& scan, const std::optional<Pose2>& T_wheels_sensor) {
  SurfacePoints points = surface_points_from_scan(scan, params_.surfaces);
  const bool sees_enough = points.size() >= params_.min_points;
  const Pose2 predicted = num_scans_ == 0 ? Pose2{} : motion_.next(T_wheels_sensor);
  const bool has_odometry = motion_.has_odometry(T_wheels_sensor);
  const bool is_anywhere = gap_.add(scan) && !has_odometry;
  TrackedPose tracked;
  tracked.T_odom_sensor = predicted;
  if (!sees_enough) {
    tracked.status = TrackStatus::kLost;
    tracked.score = 0.0;
  } else if (!submap_.empty()) {
    tracked =
        place(scan, sample_surface(points, points.size()), predicted, has_odometry, is_anywhere);
  }
  tracked.has_odometry = has_odometry;
  // A scan that sees next to nothing tells nothing against the submap.
  if (sees_enough) {
    num_lost_ = tracked.status == TrackStatus::kLost ? num_lost_ + 1 : 0;
    tracked.is_restart = num_lost_ >= params_.max_lost_scans || (num_lost_ > 0 && is_anywhere);
    if (tracked.is_restart) start_anew();
    keep_if_far(scan, std::move(points), tracked);
  }
  motion_.add(tracked.T_odom_sensor, T_wheels_sensor);
  if (tracked.status == TrackStatus::kRecovered || tracked.is_restart) motion_.restart();
  ++num_scans_;
  return tracked;
}

TrackedPose ScanTracker::place(const Scan& scan,
                               const SurfaceSamples& points,
                               const Pose2& predicted,
                               bool has_odometry,
                               bool is_anywhere) {
  const PredictionTrust& trust =
      has_odometry ? params_.trust_in_odometry : params_.trust_in_last_motion;
  const TrackingProblem problem{submap_images_, points, predicted, trust, marks_};
  SubmapFit fit = refine_in_submap(problem, predicted, params_.refinement);
  TrackStatus status = TrackStatus::kTracked;
  // In a bare corridor the walls fit; where they leave a direction open and do not, the place is
  // wrong.
  const double least_score =
      is_weak(fit) ? params_.recovery.below_score_if_weak : params_.recovery.below_score;
  if (is_anywhere || fit.alignment.score() < least_score) {
    const auto expected = is_anywhere ? std::nullopt : std::optional(fit);
    const auto found =
        recover(problem, submap_, scan, expected, params_.recovery, params_.refinement);
    if (is_anywhere && !found) {
      return {
          .status = TrackStatus::kLost, .T_odom_sensor = predicted, .score = 0.0, .weak = fit.weak};
    }
    if (found) fit = found->fit;
    if (found && found->is_far) status = TrackStatus::kRecovered;
  }
  if (fit.alignment.score() < params_.lost_below_score) {
    return {.status = TrackStatus::kLost,
            .T_odom_sensor = predicted,
            .score = fit.alignment.score(),
            .weak = fit.weak};
  }
  if (fit.weak.effective_points < params_.corridor.below_effective_points) {
    fit = search_along_corridor(problem, fit, params_.corridor, params_.refinement);
  }
  if (is_weak(fit) && status == TrackStatus::kTracked) status = TrackStatus::kDegenerate;
  return {.status = status,
          .T_odom_sensor = fit.T_odom_sensor,
          .score = fit.alignment.score(),
          .weak = fit.weak};
}

bool ScanTracker::is_weak(const SubmapFit& fit) const {
  return fit.weak.effective_points < params_.refinement.min_effective_points;
}

/// The old keyframes' poses no longer mean anything to the coming scans.
void ScanTracker::start_anew() {
  submap_.clear();
  submap_images_.clear();
  num_lost_ = 0;
}

void ScanTracker::keep_if_far(const Scan& scan, SurfacePoints points, TrackedPose& tracked) {
  if (!submap_.empty()) {
    if (tracked.status == TrackStatus::kLost) return;  // It would stand at a guessed place.
    const Pose2 moved = submap_.back()->T_odom_sensor.inverse() * tracked.T_odom_sensor;
    const bool is_far = std::hypot(moved.x_m, moved.y_m) > params_.keyframe_distance_m ||
                        std::abs(moved.theta_rad) > params_.keyframe_turn_rad;
    if (!is_far) return;
    if (submap_.size() == params_.num_keyframes) {
      submap_.erase(submap_.begin());
      submap_images_.erase(submap_images_.begin());
    }
  }
  tracked.is_keyframe = true;
  SurfaceImage image(scan, points, params_.image);
  submap_.push_back(std::make_shared<Keyframe>(Keyframe{.scan_index = num_scans_,
                                                        .T_odom_sensor = tracked.T_odom_sensor,
                                                        .scan = scan,
                                                        .points = std::move(points),
                                                        .image = std::move(image)}));
  submap_images_.push_back({&submap_.back()->image, tracked.T_odom_sensor});
}

}  // namespace setsquare
