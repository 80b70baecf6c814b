// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "experiments/pair_answer.hpp"
#include "experiments/simulated_run.hpp"

namespace setsquare::experiments {

/// What is true of a pair of scans of one run.
struct PairTruth {
  std::size_t reference = 0;  ///< Places of the scans in their run.
  std::size_t current = 0;
  Pose2 T_reference_current;
  double overlap = 0.0;              ///< Share of the current scan's returns, 0 to 1.
  bool is_determined = false;        ///< By the floor plan.
  double worst_direction_rad = 0.0;  ///< The least determined one, in the reference's frame.
  double clutter_share = 0.0;        ///< Of the returns, mean of both scans.
};

/// A pair and what the matchers answer.
struct PairRecord {
  PairTruth truth;
  PairAnswer ours;   ///< The default matcher.
  PairAnswer paper;  ///< The paper's method.
};

/// Which pairs are matched and by whom.
struct PairParams {
  double max_distance_m = 5.0;  ///< Between the true positions.
  bool has_paper = true;        ///< Otherwise the paper's answers stay empty.
  std::size_t every = 1;        ///< Of the pairs near enough only each so-manieth is matched.
  /// Who tells overlap and determination: as the scans' own scanner or, to keep the same pairs
  /// under fewer beams, a better one.
  ScannerModel judge_scanner = utm_30lx();
};

/// The pairs (reference before current) of a run that lie near enough, in the order of the scans.
[[nodiscard]] std::vector<PairRecord> match_pairs(const SimulatedRun& run,
                                                  const PairParams& params);

}  // namespace setsquare::experiments
