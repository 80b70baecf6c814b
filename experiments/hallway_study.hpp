// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "experiments/tally.hpp"
#include "setsquare/core/parallel.hpp"

namespace setsquare::experiments {

/// Relative pose of current in reference by another method; nothing where it fails.
using PeerMatcher = std::function<std::optional<Pose2>(const Scan& reference, const Scan& current)>;

/// bando2014, section 5.1: scans 0.4 m or 10 deg apart along a hallway, every pair of them.
struct HallwayStudyParams {
  std::size_t num_seeds = 20;  ///< Seeds 1 ... num_seeds; the first one's tables are shown.
  std::size_t num_scans = 15;
  double spacing_m = 0.4;
  double spacing_rad = rad_from_deg(10.0);
};

/// One pair and its three answers.
struct HallwayPair {
  PairRecord record;
  PairAnswer icp;  ///< MRPT's; it always claims to have matched.
};

/// One hallway: all pairs in the order (0, 1), (0, 2), ..., (1, 2), ...
struct HallwayRun {
  std::uint64_t seed = 0;
  std::vector<Pose2> T_map_base;
  FloorPlan plan;
  std::vector<HallwayPair> pairs;
};

/// Median time of a match from two scans, preparation included, in ms; NaN where not measured.
struct MatchTimes {
  double icp_ms = 0.0;
  double paper_ms = 0.0;
  double ours_ms = 0.0;
};

struct HallwayStudy {
  bool has_icp = false;
  std::vector<HallwayRun> runs;
  MatchTimes times;  ///< Of the first run's pairs, one after the other on one thread.
};

/// `icp` may be empty.
[[nodiscard]] HallwayStudy study_hallways(const HallwayStudyParams& params,
                                          const PeerMatcher& icp,
                                          std::size_t num_threads,
                                          const Progress& progress = {});

/// The three matchers' answers summed over the first `num_runs` runs.
struct HallwaySummary {
  Tally icp, paper, ours;                 ///< All pairs.
  Tally icp_high, paper_high, ours_high;  ///< Determined pairs of overlap >= 45 %.
  std::size_t num_high_undetermined = 0;
};
[[nodiscard]] HallwaySummary summarise(const HallwayStudy& study, std::size_t num_runs);

/// Aggregates of the first hallway and of all, and every pair of the first; no times.
[[nodiscard]] Json json_from(const HallwayStudy& study);
[[nodiscard]] Json json_from(const MatchTimes& times);

}  // namespace setsquare::experiments
