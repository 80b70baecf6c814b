// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <cmath>
#include <vector>

#include "apps/setsquare/progress_bar.hpp"
#include "apps/setsquare/simulate/simulate.hpp"
#include "setsquare/io/logs/carmen/writer.hpp"
#include "setsquare/io/logs/json_lines/writer.hpp"
#include "setsquare/sim/sensing/simulated_drive.hpp"

namespace setsquare::app {
namespace {

/// What the wheels report between two scans.
CarmenRobot robot_between(const StampedPose& last, const StampedPose& now) {
  const double elapsed_s = seconds_between(last.stamp, now.stamp);
  if (!(elapsed_s > 0.0)) return {now.pose, 0.0, 0.0};
  const Pose2 moved = last.pose.inverse() * now.pose;
  return {now.pose,
          std::copysign(std::hypot(moved.x_m, moved.y_m), moved.x_m) / elapsed_s,
          moved.theta_rad / elapsed_s};
}

void append_carmen(SimulatedRun& run, const SimulatedScan& simulated) {
  const StampedPose& now = run.odometry.back();
  const std::size_t last = run.odometry.size() > 1 ? run.odometry.size() - 2 : 0;
  append_carmen_true_pose(run.log, now.stamp, simulated.T_map_base, now.pose);
  append_carmen_scan(run.log, simulated.scan, robot_between(run.odometry[last], now));
}

/// Sensors are named as in a CARMEN log.
void append_json(SimulatedRun& run, const SimulatedScan& simulated) {
  const StampedPose& now = run.odometry.back();
  LogRecord record;
  record.stamp = now.stamp;
  record.T_odom_base = now.pose;
  record.kind = RecordKind::kTruePose;
  record.sensor = "TRUEPOS";
  record.T_map_base = simulated.T_map_base;
  append_json_record(run.log, record);
  record.kind = RecordKind::kScan;
  record.sensor = fmt::format("ROBOTLASER{}", simulated.scan.scanner + 1);
  record.scan = simulated.scan;
  record.T_map_base.reset();
  append_json_record(run.log, record);
}

void append(SimulatedRun& run,
            const SimulatedScan& simulated,
            const Pose2& T_odom_base,
            bool is_json) {
  const Timestamp stamp = simulated.scan.stamp;
  run.truth.push_back({stamp, simulated.T_map_base});
  run.odometry.push_back({stamp, T_odom_base});
  is_json ? append_json(run, simulated) : append_carmen(run, simulated);
  run.clutter_share += simulated.clutter_share;
}

}  // namespace

SimulatedRun run_simulation(const Building& world, const SimulateOptions& options) {
  const RobotPath path(world.route_m, options.drive.speed, options.drive.turn_at_start);
  const RayCaster caster(world.plan);
  if (!options.plan_path.empty()) require_free_route(caster, world.route_m);
  SimulatedRun run;
  run.duration_s = path.duration_s();
  run.length_m = path.length_m();
  ProgressBar progress("simulating");
  simulate_drive(caster,
                 world.people,
                 path,
                 drive_from(options),
                 [&](const DrivenScan& driven, double share_driven) {
                   append(run, driven.simulated, driven.T_odom_base, options.writes_json_lines);
                   if (run.truth.size() == 1) run.num_beams = driven.simulated.scan.num_beams();
                   progress.advance(share_driven);
                 });
  run.clutter_share /= static_cast<double>(run.truth.size());
  return run;
}

}  // namespace setsquare::app
