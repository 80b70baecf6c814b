// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/sensing/simulated_drive.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "setsquare/core/error.hpp"
#include "setsquare/sim/sensing/odometry_model.hpp"

namespace setsquare {
namespace {

constexpr double kMaxScans = 1e6;

// Parts of the seed; the building has the seed itself.
constexpr std::uint64_t kOdometryPart = 1;
constexpr std::uint64_t kFirstScanPart = 1000;
constexpr std::uint64_t kScannerParts = std::uint64_t{1} << 32;  // From scanner to scanner.

void require_holdable(double num_scans) {
  if (num_scans > kMaxScans) throw ParameterError("scans_per_s", "gives more than a million scans");
}

/// Times at a fixed rate while the robot is under way.
std::vector<double> times_at_rate(const RobotPath& path, double scans_per_s, double sweep_s) {
  if (sweep_s * scans_per_s > 1.0 + 1e-9) {
    throw ParameterError(
        "scans_per_s",
        fmt::format("the scanner sweeps for {:g} s, so at most {:g} scans a second",
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
                                   const SimulatedDriveParams& params,
                                   double sweep_s) {
  if (!params.every_m) return times_at_rate(path, params.scans_per_s, sweep_s);
  const double turning_s = path.duration_s() * params.speed.turn_rad_per_s;
  require_holdable(path.length_m() / *params.every_m + turning_s / params.every_rad);
  return sample_times(path, *params.every_m, params.every_rad);
}

/// A sweep of one of the scanners.
struct Sweep {
  double time_s = 0.0;
  std::size_t scanner = 0;
  std::size_t index = 0;  ///< Among the scanner's own.
};

/// The sweeps of all scanners, in the order of time.
std::vector<Sweep> sweeps_of(const std::vector<double>& times_s,
                             const SimulatedDriveParams& params,
                             double sweep_s) {
  const std::size_t num_scanners = std::max<std::size_t>(1, params.T_base_sensor.size());
  require_holdable(static_cast<double>(times_s.size() * num_scanners));
  const double turn_s =
      params.every_m ? sweep_s : 1.0 / (params.scans_per_s * static_cast<double>(num_scanners));
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

SimulatedMounting mounting_of(std::size_t scanner, const SimulatedDriveParams& params) {
  if (params.T_base_sensor.empty()) return {};
  const Pose2& stated = params.T_base_sensor[scanner];
  const bool is_last = scanner + 1 == params.T_base_sensor.size();
  return {is_last ? stated * params.T_stated_true : stated, stated};
}

double whole_microseconds(double time_s) { return std::round(time_s * 1e6) / 1e6; }

}  // namespace

void simulate_drive(
    const RayCaster& caster,
    const std::vector<Person>& people,
    const RobotPath& path,
    const SimulatedDriveParams& params,
    const std::function<void(const DrivenScan& scan, double share_driven)>& on_scan) {
  const ScannerModel& scanner = params.scanner;
  const std::vector<Sweep> sweeps =
      sweeps_of(times_of_scans(path, params, scanner.sweep_s), params, scanner.sweep_s);
  OdometryModel odometry(params.has_drift ? OdometryParams{} : without_drift(),
                         sub_seed(params.seed, kOdometryPart));
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    Random random = random_of(sweeps[i], params.seed);
    const SimulatedMounting mounting = mounting_of(sweeps[i].scanner, params);
    DrivenScan driven;
    driven.simulated = simulate_scan(caster,
                                     people,
                                     scanner,
                                     path,
                                     whole_microseconds(sweeps[i].time_s),
                                     random,
                                     mounting.T_base_true);
    Scan& scan = driven.simulated.scan;
    scan.scanner = static_cast<std::uint32_t>(sweeps[i].scanner);
    scan.T_base_sensor = mounting.T_base_stated;
    scan.time_increment_s = scanner.sweep_s / static_cast<double>(scan.num_beams() - 1);
    driven.T_odom_base = odometry.move_to(driven.simulated.T_map_base);
    on_scan(driven, static_cast<double>(i + 1) / static_cast<double>(sweeps.size()));
  }
}

}  // namespace setsquare
