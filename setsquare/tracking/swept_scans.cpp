// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What ScanTracker does about turns: those during a sweep, and those that nobody expected.
#include <algorithm>
#include <cmath>

#include "setsquare/tracking/arrived_scan.hpp"
#include "setsquare/tracking/scan_tracker.hpp"
#include "setsquare/tracking/sudden_turn.hpp"
#include "setsquare/tracking/sweep_turns.hpp"

namespace setsquare {

namespace {

/// Of a scan placed with two motions of its sweep: no difference.
constexpr double kSameScore = 0.01;

/// Where scans score less as a rule, one that scores still less tells nothing.
constexpr double kClearUsualScore = 0.75;

}  // namespace

SweepMotion ScanTracker::motion_to(const ArrivedScan& scan, const Pose2& T_odom_sensor) const {
  const Scan& arrived = scan.arrived();
  SweepMotion motion = even_motion(last_sensor(arrived).inverse() * T_odom_sensor,
                                   seconds_between(last_.stamp, arrived.stamp),
                                   scan.sweep_s());
  if (!params_.deskew.is_sweep_known) motion = {};
  return motion;
}

double ScanTracker::turn_sigma_rad(const ArrivedScan& scan) const {
  const double sigma_rad_per_s = gyro_.turn_rad(last_.stamp, scan.arrived().stamp)
                                     ? params_.deskew.gyro_sigma_rad_per_s
                                     : params_.deskew.motion_sigma_rad_per_s;
  return 0.5 * std::abs(scan.sweep_s()) * sigma_rad_per_s;
}

TrackedPose ScanTracker::place_swept(ArrivedScan& scan, const Pose2& predicted, bool has_odometry) {
  if (scan.sweep_s() == 0.0) return place_taken_at_once(scan, predicted, has_odometry);
  const SweepMotion expected = motion_to(scan, predicted);
  scan.deskew(expected);
  TrackedPose tracked = place_expected(scan, predicted, predicted, has_odometry);
  SweepMotion motion = expected;
  if (tracked.score < params_.deskew.sudden_turn.below_score) {
    motion = place_turned(scan, predicted, has_odometry, expected, tracked).value_or(expected);
  }
  if (tracked.status == TrackStatus::kLost) return tracked;
  TrackedPose best = tracked;
  SweepMotion best_motion = motion;
  for (int i = 0; i < params_.deskew.max_num_turns; ++i) {
    SweepMotion better = turns_seen(scan, tracked.T_odom_sensor, motion, expected, i < 2);
    if (change_rad(motion, better) < params_.deskew.converged_rad) break;
    better.way_m = motion_to(scan, tracked.T_odom_sensor).way_m;
    scan.deskew(better);
    const bool is_recovered = tracked.status == TrackStatus::kRecovered;
    tracked = place_expected(scan, tracked.T_odom_sensor, predicted, has_odometry);
    motion = better;
    // Where half a sweep sees next to nothing, the turns may run away.
    if (tracked.status == TrackStatus::kLost) break;
    if (is_recovered) tracked.status = TrackStatus::kRecovered;
    if (tracked.score < best.score - kSameScore) continue;
    best = tracked;
    best_motion = motion;
  }
  if (change_rad(best_motion, motion) > 0.0) scan.deskew(best_motion);
  return best;
}

SweepMotion ScanTracker::turns_seen(const ArrivedScan& scan,
                                    const Pose2& T_odom_sensor,
                                    const SweepMotion& motion,
                                    const SweepMotion& expected,
                                    bool is_first) {
  const SubmapRefinementParams& refinement = params_.refinement;
  return refined_turns(scan.placed_at(T_odom_sensor, motion),
                       expected,
                       turn_sigma_rad(scan),
                       submap_images_,
                       is_first ? refinement.first_step : refinement.later_steps,
                       marks_);
}

std::optional<SweepMotion> ScanTracker::place_turned(ArrivedScan& scan,
                                                     const Pose2& predicted,
                                                     bool has_odometry,
                                                     const SweepMotion& motion,
                                                     TrackedPose& tracked) {
  const SuddenTurn turn = sudden_turn_from(scan, last_sensor(scan.arrived()));
  scan.deskew(turn.motion);
  if (improves(place_expected(scan, turn.T_odom_sensor, predicted, has_odometry), tracked)) {
    return turn.motion;
  }
  scan.deskew(motion);
  return std::nullopt;
}

TrackedPose ScanTracker::place_taken_at_once(ArrivedScan& scan,
                                             const Pose2& predicted,
                                             bool has_odometry) {
  const SuddenTurnParams& params = params_.deskew.sudden_turn;
  const TrackedPose expected = place_expected(scan, predicted, predicted, has_odometry);
  const double searched_below = std::min(params.below_score, usual_score_ - params.below_usual);
  const bool is_told = usual_score_ >= kClearUsualScore && expected.score < searched_below;
  if (!is_told || long_steps_.are_usual()) return expected;
  const Pose2 unturned{predicted.x_m, predicted.y_m, last_sensor(scan.arrived()).theta_rad};
  const SuddenTurn turn = sudden_turn_from(scan, unturned);
  TrackedPose turned = expected;
  (void)improves(place_expected(scan, turn.T_odom_sensor, predicted, has_odometry), turned);
  const double turn_rad =
      wrap_to_pi(turned.T_odom_sensor.theta_rad - expected.T_odom_sensor.theta_rad);
  const bool is_sudden_turn =
      std::abs(turn_rad) >= params.min_turn_rad && turned.score >= usual_score_ - params.near_usual;
  return is_sudden_turn ? turned : expected;
}

SuddenTurn ScanTracker::sudden_turn_from(const ArrivedScan& scan, const Pose2& unturned) const {
  const Scan& arrived = scan.arrived();
  return find_sudden_turn(
      {arrived, unturned, seconds_between(last_.stamp, arrived.stamp), scan.sweep_s()},
      submap_images_,
      params_.surfaces,
      params_.deskew.sudden_turn);
}

bool ScanTracker::improves(const TrackedPose& turned, TrackedPose& tracked) const {
  const double least_score = tracked.score + params_.deskew.sudden_turn.min_gain;
  const bool is_better = turned.status != TrackStatus::kLost && turned.score > least_score;
  if (is_better) tracked = turned;
  return is_better;
}

}  // namespace setsquare
