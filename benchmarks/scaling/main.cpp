// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Time per scan of the mapper in a small office building and in one of ten times its area, driven
// ten times as far.
#include <sys/resource.h>

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

#include "benchmarks/scaling/block_building.hpp"
#include "benchmarks/scaling/timed_mapper.hpp"
#include "experiments/full_mapper.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/sim/sensing/odometry_model.hpp"
#include "setsquare/sim/sensing/simulated_scan.hpp"

namespace setsquare {
namespace {

constexpr double kScansPerMetre = 13631.0 / 508.0;  // Those of the log "intel".

struct ScalingOptions {
  BlockBuildingSize large = {8, 5, 5080.0};
  std::size_t num_threads = 1;
  std::uint64_t seed = 1;
  bool has_odometry = false;
};

/// 180 beams over 180 deg, as in that log.
ScannerModel scanner_of_log() { return with_num_beams(with_field_of_view(utm_30lx(), kPi), 180); }

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// Maps a simulated log, scan by scan; nothing of it is stored. Returns microseconds per scan.
double measure(const BlockBuildingSize& size, const ScalingOptions& options) {
  const Building building = make_block_building(size, options.seed);
  const RayCaster caster(building.plan);
  const RobotPath path(building.route_m);
  const ScannerModel scanner = scanner_of_log();
  const auto num_scans = static_cast<std::size_t>(path.length_m() * kScansPerMetre);
  OdometryModel wheels({}, sub_seed(options.seed, 1));
  MapperParams params;
  params.num_threads = options.num_threads;
  TimedMapper mapper(params);
  std::vector<Pose2> truth;
  for (std::size_t i = 0; i < num_scans; ++i) {
    Random random(sub_seed(options.seed, 1000 + i));
    const double share = static_cast<double>(i) / static_cast<double>(num_scans);
    const SimulatedScan simulated =
        simulate_scan(caster, building.people, scanner, path, share * path.duration_s(), random);
    std::optional<Pose2> T_wheels_base;
    if (options.has_odometry) T_wheels_base = wheels.move_to(simulated.T_map_base);
    mapper.add(simulated.scan, T_wheels_base);
    truth.push_back(simulated.T_map_base);
  }
  const Map track = mapper.finish();
  const auto errors = experiments::map_errors(track, truth);
  const double us_a_scan = 1e6 / static_cast<double>(num_scans);
  const MapperTimes& times = mapper.times();
  std::printf(
      "| %zu x %zu | %.0f | %zu | %zu | %.0f | %.0f | %.0f | %.0f | %.1f | %.0f | %.3f | "
      "%.3f | %.2f | %zu | %zu (%zu) |\n",
      size.num_columns,
      size.num_rows,
      path.length_m(),
      num_scans,
      mapper.num_keyframes(),
      us_a_scan * times.tracking_s,
      us_a_scan * times.closing_s,
      us_a_scan * times.finishing_s,
      us_a_scan * times.all_s(),
      times.wall_s,
      peak_memory_mb(),
      errors.mean_m,
      errors.highest_m,
      deg_from_rad(errors.heading_mean_rad),
      errors.closures.num_accepted,
      errors.closures.num_wrong,
      errors.closures.num_wrong_heavy);
  std::fflush(stdout);
  return us_a_scan * times.all_s();
}

int run(const ScalingOptions& options) {
  std::printf(
      "| blocks | m driven | scans | keyframes | tracking [us a scan] | closing | "
      "finishing | all | wall [s] | peak [MB] | ATE mean [m] | max | heading [deg] | "
      "closures | of those wrong (heavy) |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  const double small_us = measure({2, 2, 508.0}, options);
  const double large_us = measure(options.large, options);
  std::printf("\ntime per scan, large over small: %.2f\n", large_us / small_us);
  return 0;
}

}  // namespace
}  // namespace setsquare

int main(int argc, char** argv) {
  setsquare::ScalingOptions options;
  for (int i = 1; i < argc; ++i) {
    const auto number = [&](auto& value) {
      if (++i >= argc) return false;
      const char* const end = argv[i] + std::strlen(argv[i]);
      return std::from_chars(argv[i], end, value).ptr == end && value > 0;
    };
    bool is_known = false;
    if (std::strcmp(argv[i], "--threads") == 0) {
      is_known = number(options.num_threads);
    } else if (std::strcmp(argv[i], "--seed") == 0) {
      is_known = number(options.seed);
    } else if (std::strcmp(argv[i], "--odometry") == 0) {
      is_known = options.has_odometry = true;
    } else if (std::strcmp(argv[i], "--third") == 0) {
      is_known = true;
      options.large = {4, 3, 1524.0};
    }
    if (is_known) continue;
    std::fprintf(stderr, "usage: mapper_scaling [--threads N] [--seed N] [--odometry] [--third]\n");
    return 2;
  }
  return setsquare::run(options);
}
