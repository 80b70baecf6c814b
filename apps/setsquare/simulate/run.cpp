// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "apps/setsquare/progress_bar.hpp"
#include "apps/setsquare/simulate/simulate.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/io/logs/carmen/writer.hpp"
#include "setsquare/io/logs/json_lines/writer.hpp"
#include "setsquare/sim/sensing/odometry_model.hpp"
#include "setsquare/sim/sensing/simulated_scan.hpp"

namespace setsquare::app {
namespace {

constexpr double kMaxScans = 1e6;

// Parts of the seed; the building has the seed itself.
constexpr std::uint64_t kOdometryPart = 1;
constexpr std::uint64_t kFirstScanPart = 1000;
constexpr std::uint64_t kScannerParts = std::uint64_t{1} << 32;  // From scanner to scanner.

void require_holdable(double num_scans) {
  if (num_scans > kMaxScans) throw Error("the run would have more than a million scans");
}

/// Times at a fixed rate while the robot is under way.
std::vector<double> times_at_rate(const RobotPath& path, double scans_per_s, double sweep_s) {
  if (sweep_s * scans_per_s > 1.0 + 1e-9) {
    throw Error(fmt::format("--rate: the scanner sweeps for {:g} s, so at most {:g} scans a second",
                            sweep_s,
                            1.0 / sweep_s));
  }
  const double last = std::floor(path.duration_s() * scans_per_s + 1e-9);
  require_holdable(last + 1.0);
  std::vector<double> times_s;
  for (int i = 0; i <= static_cast<int>(last); ++i) times_s.push_back(i / scans_per_s);
  return times_s;
}

std::vector<double> times_of_scans(const RobotPath& path,
                                   const SimulateOptions& options,
                                   double sweep_s) {
  if (!options.every_m) return times_at_rate(path, options.scans_per_s, sweep_s);
  const double every_rad = rad_from_deg(options.every_deg);
  const double turning_s = path.duration_s() * options.speed.turn_rad_per_s;
  require_holdable(path.length_m() / *options.every_m + turning_s / every_rad);
  return sample_times(path, *options.every_m, every_rad);
}

/// A sweep of one of the scanners.
struct Sweep {
  double time_s = 0.0;
  std::size_t scanner = 0;
  std::size_t index = 0;  ///< Among the scanner's own.
};

/// The sweeps of all scanners, in the order of time.
std::vector<Sweep> sweeps_of(const std::vector<double>& times_s,
                             const SimulateOptions& options,
                             double sweep_s) {
  const std::size_t num_scanners = std::max<std::size_t>(1, options.T_base_sensor.size());
  require_holdable(static_cast<double>(times_s.size() * num_scanners));
  const double turn_s =
      options.every_m ? sweep_s : 1.0 / (options.scans_per_s * static_cast<double>(num_scanners));
  std::vector<Sweep> sweeps;
  for (std::size_t scanner = 0; scanner < num_scanners; ++scanner) {
    const double late_s = static_cast<double>(scanner) * turn_s;
    for (std::size_t i = 0; i < times_s.size(); ++i) {
      sweeps.push_back({times_s[i] + late_s, scanner, i});
    }
  }
  std::stable_sort(sweeps.begin(), sweeps.end(), [](const Sweep& a, const Sweep& b) {
    return std::tie(a.time_s, a.scanner) < std::tie(b.time_s, b.scanner);
  });
  return sweeps;
}

/// A separate seed: a scan does not depend on how many came before.
Random random_of(const Sweep& sweep, std::uint64_t seed) {
  return Random(sub_seed(seed, kFirstScanPart + sweep.index + sweep.scanner * kScannerParts));
}

/// Where a scanner is mounted, truly and as the log says.
struct SimulatedMounting {
  Pose2 T_base_true;
  Pose2 T_base_stated;
};

SimulatedMounting mounting_of(std::size_t scanner, const SimulateOptions& options) {
  if (options.T_base_sensor.empty()) return {};
  const Pose2& stated = options.T_base_sensor[scanner];
  const bool is_last = scanner + 1 == options.T_base_sensor.size();
  return {is_last ? stated * options.T_stated_true : stated, stated};
}

double whole_microseconds(double time_s) { return std::round(time_s * 1e6) / 1e6; }

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
  const ScannerModel scanner = scanner_from(options);
  const RobotPath path(world.route_m, options.speed, options.turn_at_start);
  const std::vector<Sweep> sweeps =
      sweeps_of(times_of_scans(path, options, scanner.sweep_s), options, scanner.sweep_s);
  const RayCaster caster(world.plan);
  if (!options.plan_path.empty()) require_free_route(caster, world.route_m);
  OdometryModel odometry(options.has_drift ? OdometryParams{} : without_drift(),
                         sub_seed(options.seed, kOdometryPart));
  SimulatedRun run;
  run.duration_s = path.duration_s();
  run.length_m = path.length_m();
  ProgressBar progress("simulating");
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    Random random = random_of(sweeps[i], options.seed);
    const SimulatedMounting mounting = mounting_of(sweeps[i].scanner, options);
    SimulatedScan simulated = simulate_scan(caster,
                                            world.people,
                                            scanner,
                                            path,
                                            whole_microseconds(sweeps[i].time_s),
                                            random,
                                            mounting.T_base_true);
    simulated.scan.scanner = static_cast<std::uint32_t>(sweeps[i].scanner);
    simulated.scan.T_base_sensor = mounting.T_base_stated;
    const auto num_steps = static_cast<double>(simulated.scan.num_beams() - 1);
    simulated.scan.time_increment_s = scanner.sweep_s / num_steps;
    append(run, simulated, odometry.move_to(simulated.T_map_base), options.writes_json_lines);
    if (i == 0) run.num_beams = simulated.scan.num_beams();
    progress.advance(static_cast<double>(i + 1) / static_cast<double>(sweeps.size()));
  }
  run.clutter_share /= static_cast<double>(sweeps.size());
  return run;
}

}  // namespace setsquare::app
