// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/answer.hpp"

#include <cmath>
#include <optional>
#include <vector>

#include "setsquare/matching/aliases.hpp"
#include "setsquare/matching/distinct_wall.hpp"
#include "setsquare/matching/information.hpp"
#include "setsquare/matching/probability.hpp"
#include "setsquare/matching/same_place.hpp"
#include "setsquare/matching/sweep_refinement.hpp"
#include "setsquare/matching/trace.hpp"
#include "setsquare/matching/verdict.hpp"
#include "setsquare/matching/wall_kinds.hpp"
#include "setsquare/paper/projected_profile.hpp"
#include "setsquare/paper/zncc.hpp"

namespace setsquare {
namespace {

/// Direction of the reference's walls modulo 90 deg, to a bin: good enough for a profile.
double wall_direction(const AngleHistogram& histogram) {
  constexpr int kQuarter = AngleHistogram::kNumBins / 4;
  int best = 0;
  static_assert(AngleHistogram::kNumBins % 4 == 0);
  float best_length = -1.0F;
  for (int bin = 0; bin < kQuarter; ++bin) {
    float length = 0.0F;
    for (int turn = 0; turn < 4; ++turn) length += histogram.length_m[bin + turn * kQuarter];
    if (length > best_length) {
      best_length = length;
      best = bin;
    }
  }
  return AngleHistogram::direction_rad(best);
}

std::vector<double> coordinates(const SurfaceSamples& samples, const Pose2& T, double axis_rad) {
  const double ux = std::cos(axis_rad);
  const double uy = std::sin(axis_rad);
  const double shift_m = ux * T.x_m + uy * T.y_m;
  const double ax = std::cos(axis_rad - T.theta_rad);
  const double ay = std::sin(axis_rad - T.theta_rad);
  std::vector<double> along_m(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    along_m[i] = ax * samples.x_m[i] + ay * samples.y_m[i] + shift_m;
  }
  return along_m;
}

/// The best candidate that is another answer than the first.
std::optional<RunnerUp> runner_up(std::span<const Candidate> candidates,
                                  const AnswerParams& params) {
  const Candidate& best = candidates.front();
  for (const Candidate& other : candidates.subspan(1)) {
    if (are_same(best.T_reference_current, other.T_reference_current, params)) continue;
    return RunnerUp{other.T_reference_current, other.score};
  }
  return std::nullopt;
}

/// Measured where the search left the best candidate: candidates are compared by these.
struct CandidateMeasures {
  double score = 0.0;
  double agreement = 0.0;      ///< Share of the wall that was compared.
  double contradiction = 0.0;  ///< Likewise.
  std::optional<RunnerUp> runner_up;
};

CandidateMeasures measure_candidate(std::span<const Candidate> candidates,
                                    const AnswerParams& params) {
  const Candidate& best = candidates.front();
  return {.score = best.score,
          .agreement = best.evidence.agreeing_m / best.evidence.wall_m,
          .contradiction = best.evidence.contradicted_m / best.evidence.wall_m,
          .runner_up = runner_up(candidates, params)};
}

/// Measured at the refined pose, which is the answer's.
struct PoseMeasures {
  TwoWayEvidence two_way;
  double overlap = 0.0;  ///< Share of the current scan's wall that agrees with the reference's.
  AxisZncc zncc;
  double distinct_wall_m = 0.0;
  WallKinds kinds;  ///< Of both scans, summed.
};

PoseMeasures measure_pose(const PreparedScan& reference,
                          const PreparedScan& current,
                          const Pose2& T,
                          const MatchParams& params) {
  const double tolerance_m = params.score.tolerance_m;
  const Evidence seen = align_one_way(reference.image(), current.fine, T, tolerance_m).evidence;
  const Evidence seen_back =
      align_one_way(current.image(), reference.fine, T.inverse(), tolerance_m).evidence;
  const TwoWayKinds kinds = wall_kinds(reference.fine_alignment(), current.fine_alignment(), T);
  WallKinds sum = kinds.forward;
  sum += kinds.backward;
  return {.two_way = {.forward = seen, .backward = seen_back},
          .overlap = seen.wall_m > 0.0 ? seen.agreeing_m / seen.wall_m : 0.0,
          .zncc = axis_zncc(reference, current, T),
          .distinct_wall_m = distinct_wall_m(
              reference.fine_alignment(), current.fine_alignment(), T, params.distinct_wall),
          .kinds = sum};
}

/// From the best candidate to the answer's pose.
SweepRefinement refine_answer(const PreparedScan& reference,
                              const PreparedScan& current,
                              const Candidate& best,
                              const MatchParams& params) {
  const Pose2 T_rigid = refine(reference.dense_alignment(),
                               current.dense_alignment(),
                               best.T_reference_current,
                               params.refinement.final_tolerances_m);
  return refine_with_turns(reference.swept(),
                           current.swept(),
                           T_rigid,
                           params.refinement.sweep_tolerance_m,
                           params.sweep);
}

/// The direction of the position that the walls leave open; none in a round hall, where it is the
/// rotation that they leave open.
std::optional<double> open_direction_rad(const WallConstraint& constraint,
                                         const AnswerParams& params) {
  if (constraint.turning_m3 < params.min_turning_m3) return std::nullopt;
  return constraint.open_direction_rad;
}

/// Of a degenerate answer what nothing holds is taken out of the information.
void take_out_open_direction(std::optional<double> open_rad, MatchResult& result) {
  result.degenerate_direction_rad = open_rad;
  result.information =
      without_direction(result.information,
                        open_rad ? Eigen::Vector3d(std::cos(*open_rad), std::sin(*open_rad), 0.0)
                                 : Eigen::Vector3d(Eigen::Vector3d::UnitZ()));
}

/// What the probability is computed from, and the motions under which the place looks the same.
struct Belief {
  ProbabilityEvidence evidence;
  std::vector<Pose2> aliases;

  [[nodiscard]] double probability() const { return match_probability(evidence, aliases.size()); }
};

Belief believe(const PreparedScan& reference,
               const PreparedScan& current,
               std::span<const Candidate> candidates,
               const CandidateMeasures& ranked,
               const PoseMeasures& measured,
               const WallConstraint& constraint,
               const MatchParams& params) {
  const double runner_up_score = ranked.runner_up ? ranked.runner_up->score : 0.0;
  Belief belief;
  belief.evidence = {.kinds = measured.kinds,
                     .constraint = constraint,
                     .score = ranked.score,
                     .margin = score_margin(ranked.score, runner_up_score, params.answer),
                     .one_way_share = one_way_share(measured.two_way),
                     .distinct_wall_m = measured.distinct_wall_m};
  // Aliases make a probable answer doubtful; of another nothing is lost.
  constexpr double kProbable = 0.5;
  if (params.alias.is_on && match_probability(belief.evidence) > kProbable) {
    belief.aliases =
        find_aliases(reference, current, candidates, measured.kinds.tight_m, params.alias);
  }
  return belief;
}

/// Whether an answer that stands may still be of two places that look alike: its evidence is asked
/// only then.
bool may_be_elsewhere(const VerdictEvidence& evidence, const AnswerParams& params) {
  return std::isfinite(params.min_place_log_odds) &&
         evidence.probability < params.sure_probability &&
         verdict(evidence, params) == MatchStatus::kMatched;
}

TracedVerdict traced(const VerdictEvidence& evidence,
                     const Belief& belief,
                     const AnswerParams& params) {
  return {.constraint = evidence.constraint,
          .two_way = evidence.two_way,
          .distinct_wall_m = evidence.distinct_wall_m,
          .min_distinct_m = params.min_distinct_m,
          .probability = belief.evidence,
          .place_log_odds = evidence.place_log_odds,
          .aliases = belief.aliases};
}

}  // namespace

AxisZncc axis_zncc(const PreparedScan& reference,
                   const PreparedScan& current,
                   const Pose2& T_reference_current) {
  const double direction_rad = wall_direction(reference.histogram);
  const auto correlate_along = [&](double axis_rad) {
    const auto reference_profile =
        profile_of_coordinates(coordinates(reference.fine, {}, axis_rad), {});
    const auto current_profile =
        profile_of_coordinates(coordinates(current.fine, T_reference_current, axis_rad), {});
    return zncc(reference_profile.counts, current_profile.counts);
  };
  return {correlate_along(direction_rad), correlate_along(direction_rad + 0.5 * kPi)};
}

MatchResult answer(const PreparedScan& reference,
                   const PreparedScan& current,
                   std::span<const Candidate> candidates,
                   const MatchParams& params,
                   MatchTrace* trace) {
  if (candidates.empty()) return {.status = MatchStatus::kNoOverlap};
  const SweepRefinement refined = refine_answer(reference, current, candidates.front(), params);
  // Refinement led out of the bounds: this is neither the answer nor a rival of the others.
  if (!params.bounds.may_hold(refined.T_reference_current)) {
    return answer(reference, current, candidates.subspan(1), params, trace);
  }
  const CandidateMeasures ranked = measure_candidate(candidates, params.answer);
  const PoseMeasures measured =
      measure_pose(reference, current, refined.T_reference_current, params);
  const WallConstraint constraint = wall_constraint(refined.pose_hessian);
  const Belief belief =
      believe(reference, current, candidates, ranked, measured, constraint, params);
  VerdictEvidence evidence{.candidates = candidates,
                           .runner_up_score = ranked.runner_up ? ranked.runner_up->score : 0.0,
                           .constraint = constraint,
                           .two_way = measured.two_way,
                           .distinct_wall_m = measured.distinct_wall_m,
                           .probability = belief.probability(),
                           .num_aliases = belief.aliases.size()};

  if (may_be_elsewhere(evidence, params.answer)) {
    evidence.place_log_odds = place_log_odds(
        place_evidence(reference, current, refined.T_reference_current, belief.evidence));
  }

  MatchResult result;
  result.status = verdict(evidence, params.answer);
  if (trace != nullptr) trace->verdict = traced(evidence, belief, params.answer);
  result.probability = evidence.probability;
  if (!belief.aliases.empty()) result.alias = belief.aliases.front();
  result.T_reference_current = refined.T_reference_current;
  result.information = match_information(refined.normal);
  result.score = ranked.score;
  result.agreement = ranked.agreement;
  result.contradiction = ranked.contradiction;
  result.runner_up = ranked.runner_up;
  result.overlap = measured.overlap;
  result.zncc_x = measured.zncc.x;
  result.zncc_y = measured.zncc.y;
  if (result.status == MatchStatus::kDegenerate) {
    take_out_open_direction(open_direction_rad(constraint, params.answer), result);
  }
  return result;
}

}  // namespace setsquare
