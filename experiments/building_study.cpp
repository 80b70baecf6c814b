// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/building_study.hpp"

namespace setsquare::experiments {

BuildingStudy study_buildings(const BuildingStudyParams& params,
                              std::size_t num_threads,
                              const Progress& progress) {
  BuildingStudy study;
  study.buildings.resize(kAllBuildingClasses.size() * params.num_seeds);
  const auto study_one = [&](std::size_t task) {
    BuildingPairs& building = study.buildings[task];
    building.building_class = kAllBuildingClasses[task / params.num_seeds];
    building.seed = 1 + task % params.num_seeds;
    const SimulatedRun run = simulate_study_run(building.building_class, building.seed, params.run);
    building.num_scans = run.scans.size();
    Spread clutter;
    for (const SimulatedScan& simulated : run.scans) clutter.add(simulated.clutter_share);
    building.clutter_share = clutter.mean();
    building.pairs = match_pairs(run, params.pairs);
  };
  run_in_parallel(study.buildings.size(), num_threads, study_one, progress);
  return study;
}

}  // namespace setsquare::experiments
