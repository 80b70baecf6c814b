// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/log_tracker.hpp"

#include <utility>

#include "setsquare/core/finite_pose.hpp"
#include "setsquare/scan/isolated_returns.hpp"

namespace setsquare {

LogTracker::LogTracker(const MapperParams& params)
    : params_(params),
      sweeps_(params.tracker),
      robot_parts_(params.leaves_out_robot_parts),
      tracker_(params.tracker),
      scanners_(params.mounting),
      uncertainty_(params.motion) {
  params_.validate();
}

TrackedPose LogTracker::add(const Scan& scan,
                            const std::optional<Pose2>& T_wheels_base,
                            TrackSteps& steps) {
  const TrackedPose tracked = track(scan, T_wheels_base, steps);
  const auto again = take_tracking_again();
  if (!again) return tracked;
  const TrackedPose tracked_again = again->run(steps);
  *this = again->take();
  return tracked_again;
}

void LogTracker::add_turn_rate(Timestamp stamp, double turn_rad_per_s) {
  sweeps_.add_turn_rate(stamp, turn_rad_per_s);
  robot_parts_.add_turn_rate(stamp, turn_rad_per_s);
  turn(stamp, turn_rad_per_s);
}

void LogTracker::turn(Timestamp stamp, double turn_rad_per_s) {
  unjudged_.add(MapperTurnRate{stamp, turn_rad_per_s});
  tracker_.add_turn_rate(stamp, turn_rad_per_s);
}

TrackedPose LogTracker::track(const Scan& scan,
                              const std::optional<Pose2>& T_wheels_base,
                              TrackSteps& steps) {
  require_valid(scan, T_wheels_base);
  steps.begins_again = false;
  steps.steps.clear();
  sweeps_.add(scan, T_wheels_base);
  robot_parts_.add(scan, T_wheels_base);
  return place(scan, T_wheels_base, steps.steps);
}

void LogTracker::require_valid(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  scan.validate();
  require_finite_pose(scan.T_base_sensor, "T_base_sensor");
  if (T_wheels_base) require_finite_pose(*T_wheels_base, "T_wheels_base");
}

TrackedPose LogTracker::place(const Scan& scan,
                              const std::optional<Pose2>& T_wheels_base,
                              std::vector<TrackStep>& steps) {
  unjudged_.add(MapperScan{scan, T_wheels_base});
  const std::optional<Scan> mended = sweeps_.mended(scan);
  const Scan& timed = mended ? *mended : scan;
  const std::optional<Scan> without_parts = robot_parts_.cleared(timed);
  const Scan& seen = without_parts ? *without_parts : timed;
  const std::optional<Scan> cleared = without_isolated_returns(seen);
  return place_cleared(cleared ? *cleared : seen, odometry_.believed(seen, T_wheels_base), steps);
}

TrackedPose LogTracker::place_cleared(const Scan& scan,
                                      const std::optional<Pose2>& T_wheels_base,
                                      std::vector<TrackStep>& steps) {
  if (!scanners_.admit(scan, T_wheels_base, tracker_)) {
    return tracker_.expected(scan, T_wheels_base);
  }
  num_with_odometry_ += T_wheels_base.has_value();
  TrackStep& step = steps.emplace_back();
  const TrackedPose tracked = tracker_.track(scan, T_wheels_base);
  const double open_sigma_m = uncertainty_.add(tracked, {scan.scanner, scan.stamp});
  step.scan = {.stamp = scan.stamp,
               .status = tracked.status,
               .has_odometry = tracked.has_odometry,
               .is_restart = tracked.is_restart,
               .is_same_again = tracked.is_same_again,
               .score = static_cast<float>(tracked.score),
               .T_odom_sensor = tracked.T_odom_sensor,
               .T_base_sensor = scan.T_base_sensor,
               .open = {.direction = tracked.open.direction,
                        .sigma_m = open_sigma_m,
                        .is_turn_open = tracked.turn_bound_share < 1.0,
                        .turn_sigma_rad = uncertainty_.open_turn_sigma_rad(),
                        .turn_motion_m = tracked.turn_motion_m}};
  const bool is_kept = kept_.takes(tracked, scan.scanner);
  if (tracked.is_keyframe) {
    const KeyframePtr& keyframe = tracker_.submap().back();
    const double share_of_place = 1.0 / static_cast<double>(tracker_.num_scanners());
    step.keyframe = {keyframe, uncertainty_.take(share_of_place), share_of_place};
    step.kept = keyframe->scan;
  } else if (is_kept) {
    const std::optional<Scan>& deskewed = tracker_.deskewed_scan();
    step.kept = std::make_shared<const Scan>(deskewed ? *deskewed : scan);
  }
  return tracked;
}

std::unique_ptr<TrackingAgain> LogTracker::take_tracking_again() {
  std::vector<MapperInput> inputs = sweeps_.take_to_map_again();
  if (inputs.empty()) inputs = robot_parts_.take_to_map_again();
  const bool has_other_scans = !inputs.empty();
  if (!has_other_scans) inputs = unjudged_.take_to_map_again(tracker_.odometry().verdict);
  if (inputs.empty()) return nullptr;
  LogTracker again(params_);
  // A copy, then moved: to copy onto one costs the build two seconds more.
  again.sweeps_ = SweepSearch(sweeps_);
  again.robot_parts_ = RobotPartSearch(robot_parts_);
  if (!has_other_scans) {
    again.tracker_.judge_odometry_by(tracker_.judged_odometry());
    again.unjudged_.close();
  }
  return std::make_unique<TrackingAgain>(std::move(again), std::move(inputs));
}

SensorReports LogTracker::sensors() const {
  SensorReports reports{.scanners = scanners_.results(),
                        .gyro = tracker_.gyro(),
                        .odometry = tracker_.odometry(),
                        .sweep = sweeps_.report(),
                        .num_with_odometry = num_with_odometry_};
  reports.odometry.num_ignored += odometry_.num_ignored();
  return reports;
}

TrackedPose TrackingAgain::run(TrackSteps& steps) {
  steps.begins_again = true;
  steps.steps.clear();
  TrackedPose last;
  for (const MapperInput& input : inputs_) {
    if (const auto* rate = std::get_if<MapperTurnRate>(&input)) {
      tracker_.turn(rate->stamp, rate->turn_rad_per_s);
    } else {
      const auto& [scan, T_wheels_base] = std::get<MapperScan>(input);
      last = tracker_.place(scan, T_wheels_base, steps.steps);
    }
  }
  inputs_ = {};
  return last;
}

}  // namespace setsquare
