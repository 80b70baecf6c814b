// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The mapper in simulated buildings of every class, against the truth; a table in Markdown.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include "experiments/full_mapper.hpp"
#include "experiments/simulated_run.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/core/parallel.hpp"

namespace setsquare::experiments {
namespace {

constexpr double kScansPerSecond = 10.0;

struct Task {
  BuildingClass building_class;
  std::uint64_t seed = 0;
  bool has_odometry = false;
};

struct Outcome {
  Task task;
  std::size_t num_scans = 0;
  double length_m = 0.0;
  MapErrors errors;
};

/// What `setsquare simulate --building CLASS --seed SEED` drives, mapped.
Outcome run_task(const Task& task) {
  const Building building = make_building(task.building_class, task.seed);
  const RobotPath path(building.route_m);
  std::vector<double> times_s;
  for (int i = 0; i <= path.duration_s() * kScansPerSecond; ++i) {
    times_s.push_back(i / kScansPerSecond);
  }
  const SimulatedRun run = simulate_run(building, path, times_s, {}, task.seed);
  std::optional<std::uint64_t> odometry_seed;
  if (task.has_odometry) odometry_seed = sub_seed(task.seed, 1);
  std::vector<Pose2> truth;
  for (const SimulatedScan& scan : run.scans) truth.push_back(scan.T_map_base);
  const MapErrors errors = map_errors(track_by_mapper(run.scans, odometry_seed), truth);
  return {task, run.scans.size(), path.length_m(), errors};
}

void print_row(const std::string& name, const Outcome& outcome) {
  const MapErrors& errors = outcome.errors;
  std::printf(
      "| %s | %s | %zu | %.0f | %.3f | %.3f | %.3f | %.2f | %zu | %zu | %zu | %zu (%zu) |\n",
      name.c_str(),
      outcome.task.has_odometry ? "yes" : "no",
      outcome.num_scans,
      outcome.length_m,
      errors.mean_m,
      errors.highest_m,
      deg_from_rad(errors.heading_mean_rad),
      deg_from_rad(errors.heading_highest_rad),
      errors.num_lost,
      errors.num_unjoined,
      errors.closures.num_accepted,
      errors.closures.num_wrong,
      errors.closures.num_wrong_heavy);
}

/// Means of the means, highest of the highest, sums of the counts.
Outcome summary_of(const std::vector<Outcome>& outcomes) {
  Outcome sum{outcomes.front().task, 0, 0.0, {}};
  const auto n = static_cast<double>(outcomes.size());
  for (const Outcome& outcome : outcomes) {
    sum.num_scans += outcome.num_scans;
    sum.length_m += outcome.length_m;
    sum.errors.mean_m += outcome.errors.mean_m / n;
    sum.errors.heading_mean_rad += outcome.errors.heading_mean_rad / n;
    sum.errors.highest_m = std::max(sum.errors.highest_m, outcome.errors.highest_m);
    sum.errors.heading_highest_rad =
        std::max(sum.errors.heading_highest_rad, outcome.errors.heading_highest_rad);
    sum.errors.num_lost += outcome.errors.num_lost;
    sum.errors.num_unjoined += outcome.errors.num_unjoined;
    sum.errors.closures += outcome.errors.closures;
  }
  return sum;
}

void print_table(const std::vector<Outcome>& outcomes, std::size_t num_seeds, bool is_long) {
  std::printf(
      "| building | odometry | scans | m driven | ATE mean [m] | max | heading mean [deg] | "
      "max | lost scans | pieces not joined | closures | of those wrong (heavy) |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (std::size_t i = 0; i < outcomes.size(); i += num_seeds) {
    const std::vector<Outcome> group(outcomes.begin() + i, outcomes.begin() + i + num_seeds);
    const std::string name(to_string(group.front().task.building_class));
    for (const Outcome& outcome : group) {
      if (is_long) print_row(name + ", seed " + std::to_string(outcome.task.seed), outcome);
    }
    print_row(name, summary_of(group));
  }
}

int run(std::size_t num_seeds, bool is_long) {
  std::vector<Task> tasks;
  for (const BuildingClass building_class : kAllBuildingClasses) {
    for (const bool has_odometry : {false, true}) {
      for (std::uint64_t seed = 1; seed <= num_seeds; ++seed) {
        tasks.push_back({building_class, seed, has_odometry});
      }
    }
  }
  std::vector<Outcome> outcomes(tasks.size());
  run_in_parallel(tasks.size(), std::thread::hardware_concurrency(), [&](std::size_t task) {
    outcomes[task] = run_task(tasks[task]);
  });
  print_table(outcomes, num_seeds, is_long);
  return 0;
}

}  // namespace
}  // namespace setsquare::experiments

int main(int argc, char** argv) {
  std::size_t num_seeds = 5;
  bool is_long = false;
  for (int i = 1; i < argc; ++i) {
    const char* const end = argv[i] + std::strlen(argv[i]);
    if (std::strcmp(argv[i], "--each") == 0) {
      is_long = true;
    } else if (std::from_chars(argv[i], end, num_seeds).ptr != end || num_seeds < 1) {
      std::fprintf(stderr, "usage: map_buildings [SEEDS] [--each]\n");
      return 2;
    }
  }
  return setsquare::experiments::run(num_seeds, is_long);
}
