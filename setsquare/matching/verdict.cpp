// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>

#include "setsquare/core/symmetric_eigen.hpp"

namespace setsquare {
namespace {

/// Whether a different pose explains nearly as much and is contradicted as little. Its score may be
/// lower only because less is seen in common, which speaks for small motion, not against the pose.
bool has_rival(std::span<const Candidate> candidates, const AnswerParams& params) {
  const Candidate& best = candidates.front();
  const double max_share = contradicted_share(best.evidence) + params.rival_contradiction;
  const double max_m = best.evidence.contradicted_m + params.rival_contradiction_m;
  return std::any_of(candidates.begin() + 1, candidates.end(), [&](const Candidate& other) {
    return !are_same(best.T_reference_current, other.T_reference_current, params) &&
           other.evidence.agreeing_m >= params.rival_agreement * best.evidence.agreeing_m &&
           other.evidence.contradicted_m <= max_m &&
           contradicted_share(other.evidence) <= max_share;
  });
}

/// Whether score, margin and distinct wall speak for the answer alone.
bool stands_out(const VerdictEvidence& evidence, const AnswerParams& params) {
  const double score = evidence.candidates.front().score;
  if (score < params.low_score && evidence.constraint.all_m < params.min_wall_m) return false;
  if (evidence.distinct_wall_m < params.min_distinct_m) return false;
  const double margin = score_margin(score, evidence.runner_up_score, params);
  if (margin < params.margin_per_contradiction * one_way_share(evidence.two_way)) return false;
  return (score >= params.min_score && margin >= params.min_margin) ||
         (score >= params.min_score_alone && margin >= params.min_margin_alone);
}

/// Whether the answer is probable enough: alone, or together with the rules of the score.
bool is_probable(const VerdictEvidence& evidence, const AnswerParams& params) {
  if (evidence.probability >= params.min_probability) return true;
  return evidence.probability >= params.min_probability_by_rules && stands_out(evidence, params);
}

/// Whether the scans show one place, as far as was asked.
bool is_one_place(const VerdictEvidence& evidence, const AnswerParams& params) {
  return !evidence.place_log_odds || *evidence.place_log_odds >= params.min_place_log_odds;
}

}  // namespace

double contradicted_share(const Evidence& evidence) {
  const double judged_m = evidence.agreeing_m + evidence.contradicted_m;
  return judged_m > 0.0 ? evidence.contradicted_m / judged_m : 0.0;
}

double one_way_share(const TwoWayEvidence& two_way) {
  return std::max(contradicted_share(two_way.forward), contradicted_share(two_way.backward));
}

double score_margin(double score, double runner_up_score, const AnswerParams& params) {
  return score - std::max(runner_up_score, params.floor_score);
}

WallConstraint wall_constraint(const Eigen::Matrix3d& hessian) {
  Eigen::Matrix2d translation = hessian.topLeftCorner<2, 2>();
  if (hessian(2, 2) > 0.0) {
    translation -=
        hessian.topRightCorner<2, 1>() * hessian.bottomLeftCorner<1, 2>() / hessian(2, 2);
  }
  // What holds the rotation at the best translation for each rotation; the tiny term keeps a
  // direction without any wall from dividing by zero.
  constexpr double kTiny_m = 1e-6;
  const Eigen::Matrix2d held =
      hessian.topLeftCorner<2, 2>() + kTiny_m * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d coupling = hessian.topRightCorner<2, 1>();
  const double turning_m3 = hessian(2, 2) - coupling.dot(held.inverse() * coupling);
  const SymmetricEigen<2> held_by_walls = symmetric_eigen(translation);
  const Eigen::Vector2d axis = held_by_walls.vectors.col(0);
  const double direction_rad = std::atan2(axis.y(), axis.x());
  return {.all_m = held_by_walls.values.sum(),
          .open_direction_m = std::max(0.0, held_by_walls.values(0)),
          .turning_m3 = std::max(0.0, turning_m3),
          .open_direction_rad = direction_rad - kPi * std::floor(direction_rad / kPi)};
}

MatchStatus verdict(const VerdictEvidence& evidence, const AnswerParams& params) {
  const Evidence& best = evidence.candidates.front().evidence;
  if (!(best.agreeing_m >= params.min_agreement * best.wall_m)) return MatchStatus::kNoOverlap;
  const bool is_held = evidence.constraint.open_direction_m >= params.min_constraint_m &&
                       evidence.constraint.turning_m3 >= params.min_turning_m3;
  if (!is_held) return MatchStatus::kDegenerate;
  const bool is_alone = is_probable(evidence, params) && evidence.num_aliases == 0 &&
                        !has_rival(evidence.candidates, params) && is_one_place(evidence, params);
  return is_alone ? MatchStatus::kMatched : MatchStatus::kAmbiguous;
}

}  // namespace setsquare
