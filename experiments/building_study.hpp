// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

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

/// Overlap above which the paper's method succeeds (bando2014, section 5.1).
inline constexpr double kHighOverlap = 0.45;
inline constexpr double kMiddleOverlap = 0.30;

/// One matcher's answers over a set of pairs.
struct MatcherSummary {
  Tally all;         ///< Every pair: what matters for wrong answers and for the covariance.
  Tally determined;  ///< The pairs that the floor plan determines: errors of the successes.
  Tally high;        ///< Of those, overlap of at least kHighOverlap.
  Tally middle;      ///< Of those, overlap from kMiddleOverlap to kHighOverlap.
  /// Of the determined pairs by overlap: 0-10 %, ..., 90-100 %.
  std::array<Tally, 10> by_overlap;
  /// All pairs by overlap, for wrong answers and shares of `matched`.
  std::array<Tally, 10> all_by_overlap;
};

/// A class of buildings, or all of them.
struct BuildingSummary {
  std::string name;
  std::size_t num_buildings = 0;
  std::size_t num_pairs = 0;
  std::size_t num_high = 0;               ///< Overlap of at least kHighOverlap.
  std::size_t num_high_undetermined = 0;  ///< Of those, excluded from `high`.
  std::size_t num_below_60 = 0;           ///< Overlap below 60 %.
  Spread clutter_share;                   ///< Of the buildings.
  MatcherSummary ours;
  MatcherSummary paper;
};

/// Sums over all buildings, or over those of one class.
[[nodiscard]] BuildingSummary summarise(const BuildingStudy& study,
                                        std::optional<BuildingClass> building_class = {});

/// One summary per class, then one of all.
[[nodiscard]] std::vector<BuildingSummary> summarise_by_class(const BuildingStudy& study);

/// A pair by the building and the scans that it comes from.
struct ListedPair {
  const BuildingPairs* building = nullptr;
  const PairRecord* record = nullptr;
};

/// The pairs that a reader wants to look at, in the order of the study (which must outlive them).
struct PairLists {
  std::vector<ListedPair> wrong;     ///< The default matcher's wrong `matched`.
  std::vector<ListedPair> failures;  ///< Its failures of determined pairs of high overlap.
  std::vector<ListedPair> excluded;  ///< Of high overlap, not determined by the floor plan.
};
[[nodiscard]] PairLists list_pairs(const BuildingStudy& study);

/// Summaries by class, by overlap, and every listed pair.
[[nodiscard]] Json json_from(const BuildingStudy& study);

}  // namespace setsquare::experiments
