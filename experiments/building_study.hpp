// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "experiments/pair_record.hpp"
#include "experiments/tally.hpp"
#include "setsquare/core/parallel.hpp"

namespace setsquare::experiments {

/// Seeds 1 ... num_seeds of every class, one run through each building.
struct BuildingStudyParams {
  std::size_t num_seeds = 40;
  RunParams run;
  PairParams pairs;
};

/// The pairs of one building.
struct BuildingPairs {
  BuildingClass building_class = BuildingClass::kOffice;
  std::uint64_t seed = 0;
  std::size_t num_scans = 0;
  double clutter_share = 0.0;  ///< Of the returns, mean of the scans.
  std::vector<PairRecord> pairs;
};

/// All buildings, class by class, in the order of their seeds.
struct BuildingStudy {
  std::vector<BuildingPairs> buildings;
};

[[nodiscard]] BuildingStudy study_buildings(const BuildingStudyParams& params,
                                            std::size_t num_threads,
                                            const Progress& progress = {});

}  // namespace setsquare::experiments
