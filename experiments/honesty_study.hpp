// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "experiments/pairs.hpp"
#include "experiments/small_worlds.hpp"
#include "experiments/tally.hpp"
#include "setsquare/core/parallel.hpp"

namespace setsquare::experiments {

/// Pairs of scans that determine the pose little or not at all.
struct HonestyStudyParams {
  std::size_t num_seeds = 20;  ///< Of each world, and of pairs of different buildings.
  std::size_t num_scans = 9;   ///< Of each run: 36 pairs.
};

/// Errors and claims along one direction: actual errors against the sigmas that the information
/// claims.
struct DirectionClaim {
  Spread error_m;                       ///< Absolute errors.
  std::vector<double> claimed_sigma_m;  ///< One per pair; infinite where nothing is claimed.
};

/// All pairs of one world.
struct HonestyOutcome {
  std::string name;
  std::string truth;
  std::size_t num_pairs = 0;
  std::size_t num_determined = 0;              ///< By the floor plan, taken locally.
  std::array<std::size_t, 6> status_counts{};  ///< In the order of MatchStatus.
  std::size_t num_wrong = 0;                   ///< `matched` and off by over 0.2 m or 3 deg.
  Spread nees;                                 ///< Of those `matched` with full rank.
  /// Of the answers `degenerate`, where the plan leaves a direction open: angle between the
  /// answer's direction and the plan's.
  Spread direction_error_rad;
  /// Of the answers `matched` and `degenerate` with a pose, along the plan's worst direction and
  /// across it.
  DirectionClaim along;
  DirectionClaim across;
};

/// The answers that the default matcher has, in the order of MatchStatus: it never rejects.
inline constexpr std::array kAnswerStatuses = {MatchStatus::kMatched,
                                               MatchStatus::kAmbiguous,
                                               MatchStatus::kDegenerate,
                                               MatchStatus::kNoOverlap,
                                               MatchStatus::kTooFewPoints};

struct HonestyStudy {
  std::size_t num_seeds = 0;
  std::vector<HonestyOutcome> outcomes;  ///< One per world, then two different buildings.
};

[[nodiscard]] HonestyStudy study_honesty(const HonestyStudyParams& params,
                                         std::size_t num_threads,
                                         const Progress& progress = {});

/// Statuses, wrong answers, errors and claims of every world.
[[nodiscard]] Json json_from(const HonestyStudy& study);

}  // namespace setsquare::experiments
