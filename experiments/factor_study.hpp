// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/building_study.hpp"

namespace setsquare::experiments {

/// One value of one factor; everything else is as in the study of the buildings.
struct FactorLevel {
  std::string factor;  ///< "people", "field of view", "beams", "scanner", "motion".
  std::string level;   ///< "271".
  RunParams run;
  ScannerModel judge_scanner;  ///< Decides overlap and determination.
};

/// Every level of every factor, in the order of the page. Under fewer beams the pairs keep the
/// overlap that the whole scanner has: the same pairs are compared.
[[nodiscard]] std::vector<FactorLevel> factor_levels();

struct FactorOutcome {
  std::string factor;
  std::string level;
  BuildingSummary summary;  ///< Of all classes.
};

struct FactorStudy {
  std::size_t num_seeds = 0;  ///< Of each class.
  std::vector<FactorOutcome> outcomes;
};

/// One factor at a time over the buildings of the first seeds of every class.
[[nodiscard]] FactorStudy study_factors(std::size_t num_seeds,
                                        std::size_t num_threads,
                                        const Progress& progress = {});

/// Every level of every factor, and how many pairs each tenth of overlap has.
[[nodiscard]] Json json_from(const FactorStudy& study);

}  // namespace setsquare::experiments
