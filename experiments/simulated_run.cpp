// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/simulated_run.hpp"

#include "setsquare/sim/pairs/study_sampling.hpp"

namespace setsquare::experiments {

SimulatedRun simulate_run(const Building& building,
                          const RobotPath& path,
                          std::span<const double> times_s,
                          const RunParams& params,
                          std::uint64_t seed) {
  SimulatedRun run{RayCaster(building.plan), {}};
  const std::vector<Person> people = params.has_people ? building.people : std::vector<Person>{};
  run.scans.reserve(times_s.size());
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    Random random(sub_seed(seed, i));
    run.scans.push_back(
        simulate_scan(run.caster, people, params.scanner, path, times_s[i], random));
  }
  return run;
}

SimulatedRun simulate_study_run(BuildingClass building_class,
                                std::uint64_t seed,
                                const RunParams& params) {
  const Building building = make_building(building_class, seed);
  const RobotPath path(building.route_m, params.speed);
  // Independent of the building's own random numbers, and another for each class.
  const std::uint64_t run_seed =
      sub_seed(sub_seed(seed, 1'000), static_cast<std::uint64_t>(building_class));
  Random random(run_seed);
  constexpr std::size_t kNumScans = 16;
  return simulate_run(building, path, study_times(path, kNumScans, random), params, run_seed);
}

Pose2 true_relative_pose(const SimulatedScan& reference, const SimulatedScan& current) {
  return reference.T_map_base.inverse() * current.T_map_base;
}

}  // namespace setsquare::experiments
