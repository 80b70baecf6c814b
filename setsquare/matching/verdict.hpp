// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from answer, its only caller: the rules, tested without scans.
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <optional>
#include <span>

#include "setsquare/matching/candidates.hpp"
#include "setsquare/matching/match_params.hpp"
#include "setsquare/scan/match_result.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {

/// How firmly the walls hold the translation once the rotation is free, and the rotation once the
/// translation is.
struct WallConstraint {
  double all_m = 0.0;  ///< Metres of wall, both directions summed.
  double open_direction_m =
      0.0;                  ///< Metres of wall that hold the position along the open direction.
  double turning_m3 = 0.0;  ///< Metres of wall times squared lever arm: 0 in a bare round hall.
  double open_direction_rad = 0.0;  ///< In the reference's frame, in [0, pi).
};

/// From the normal equations of the pose, distances weighted by metres of wall.
[[nodiscard]] WallConstraint wall_constraint(const Eigen::Matrix3d& hessian);

/// The evidence of both ways apart, at the answer.
struct TwoWayEvidence {
  Evidence forward;   ///< The current scan's samples against the reference.
  Evidence backward;  ///< The reference's samples against the current scan.
};

/// What the verdict looks at.
struct VerdictEvidence {
  std::span<const Candidate> candidates;  ///< Best first, not empty; all but the first differ.
  double runner_up_score = 0.0;           ///< Of the best different pose; 0 where there is none.
  WallConstraint constraint;
  TwoWayEvidence two_way;
  double distinct_wall_m = 0.0;
  double probability = 0.0;     ///< That the answer is right, aliases counted.
  std::size_t num_aliases = 0;  ///< Motions under which the place looks the same.
  /// That the scans show one place at all; nothing where that was not asked.
  std::optional<double> place_log_odds = std::nullopt;
};

/// Share of the wall that can be judged (agreeing or contradicted) that is contradicted.
[[nodiscard]] double contradicted_share(const Evidence& evidence);

/// The larger of the shares that one scan contradicts in the other.
[[nodiscard]] double one_way_share(const TwoWayEvidence& two_way);

/// Of the score above the best different pose, or above what counts as no match at all.
[[nodiscard]] double score_margin(double score, double runner_up_score, const AnswerParams& params);

/// Whether the best candidate stands, and if not, why. An accepted wrong match is the worst
/// outcome: each rule here answers to a kind of place seen in logs (docs/method.md).
[[nodiscard]] MatchStatus verdict(const VerdictEvidence& evidence, const AnswerParams& params);

}  // namespace setsquare
