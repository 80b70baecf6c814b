// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/answer.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "setsquare/matching/distinct_wall.hpp"
#include "setsquare/matching/information.hpp"
#include "setsquare/matching/refinement.hpp"
#include "setsquare/matching/sweep_refinement.hpp"
#include "setsquare/matching/trace.hpp"
#include "setsquare/matching/verdict.hpp"
#include "setsquare/paper/projected_profile.hpp"
#include "setsquare/paper/zncc.hpp"

namespace setsquare {
namespace {

constexpr std::array kFinalTolerances_m{0.2, 0.15, 0.1};
constexpr double kFinalTolerance_m = 0.1;

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

TwoWayEvidence two_way_evidence(const PreparedScan& reference,
                                const PreparedScan& current,
                                const Pose2& T) {
  constexpr double kTolerance_m = 0.2;
  return {align_one_way(reference.image, current.fine, T, kTolerance_m).evidence,
          align_one_way(current.image, reference.fine, T.inverse(), kTolerance_m).evidence};
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

/// Names the direction that the walls leave free, or, in a round hall, none: there it is the
/// rotation; and takes it out of the information.
void forget_what_is_not_held(const WallConstraint& constraint,
                             const AnswerParams& params,
                             MatchResult& result) {
  Eigen::Vector3d free = Eigen::Vector3d::UnitZ();
  if (constraint.turning_m3 >= params.min_turning_m3) {
    const double direction_rad = constraint.weakest_direction_rad;
    result.degenerate_direction_rad = direction_rad;
    free = {std::cos(direction_rad), std::sin(direction_rad), 0.0};
  }
  result.information = without_direction(result.information, free);
}

TracedVerdict traced(const VerdictEvidence& evidence, const AnswerParams& params) {
  return {.constraint = evidence.constraint,
          .two_way = evidence.two_way,
          .distinct_wall_m = evidence.distinct_wall_m,
          .min_distinct_m = params.min_distinct_m};
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
  MatchResult result;
  if (candidates.empty()) {
    result.status = MatchStatus::kNoOverlap;
    return result;
  }
  const Candidate& best = candidates.front();
  const Pose2 T_rigid = refine(reference.dense_alignment(),
                               current.dense_alignment(),
                               best.T_reference_current,
                               kFinalTolerances_m);
  const SweepRefinement refined =
      refine_with_turns(reference.swept(), current.swept(), T_rigid, kFinalTolerance_m);
  const Pose2& T = refined.T_reference_current;
  const TwoWayEvidence two_way = two_way_evidence(reference, current, T);

  result.T_reference_current = T;
  result.information = match_information(refined.normal);
  const AxisZncc axes = axis_zncc(reference, current, T);
  result.zncc_x = axes.x;
  result.zncc_y = axes.y;
  result.score = best.score;
  result.agreement = best.evidence.agreeing_m / best.evidence.wall_m;
  result.contradiction = best.evidence.contradicted_m / best.evidence.wall_m;
  const Evidence& seen = two_way.forward;
  result.overlap = seen.wall_m > 0.0 ? seen.agreeing_m / seen.wall_m : 0.0;
  result.runner_up = runner_up(candidates, params.answer);

  const VerdictEvidence evidence{
      .candidates = candidates,
      .runner_up_score = result.runner_up ? result.runner_up->score : 0.0,
      .constraint = wall_constraint(refined.pose_hessian),
      .two_way = two_way,
      .distinct_wall_m = distinct_wall_m(reference.fine_alignment(), current.fine_alignment(), T)};
  result.status = verdict(evidence, params.answer);
  if (trace != nullptr) trace->verdict = traced(evidence, params.answer);
  if (result.status == MatchStatus::kDegenerate) {
    forget_what_is_not_held(evidence.constraint, params.answer, result);
  }
  return result;
}

}  // namespace setsquare
