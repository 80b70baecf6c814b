// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/match_answer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <vector>

#include "setsquare/matching/projected_profile.hpp"
#include "setsquare/matching/refinement.hpp"
#include "setsquare/matching/zncc.hpp"

namespace setsquare {
namespace {

constexpr std::array kFinalTolerances_m{0.2, 0.15, 0.1, 0.1, 0.1};
constexpr double kFinalTolerance_m = 0.1;
/// Standard deviation of a return's distance from its wall, and the length of wall over which such
/// deviations are alike (bumps, bias of a material): what a metre of wall is worth.
constexpr double kDistanceSigma_m = 0.02;
constexpr double kCorrelationLength_m = 0.25;

/// How firmly the walls hold the translation once the rotation is free: the weaker direction.
struct WeakestDirection {
  double all_constraint_m = 0.0;  ///< Of both directions together.
  double constraint_m = 0.0;      ///< Metres of wall that face it.
  double direction_rad = 0.0;     ///< In [0, pi).
};

WeakestDirection weakest_direction(const Eigen::Matrix3d& hessian) {
  Eigen::Matrix2d translation = hessian.topLeftCorner<2, 2>();
  if (hessian(2, 2) > 0.0) {
    translation -=
        hessian.topRightCorner<2, 1>() * hessian.bottomLeftCorner<1, 2>() / hessian(2, 2);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(translation);
  const Eigen::Vector2d axis = solver.eigenvectors().col(0);
  const double direction_rad = std::atan2(axis.y(), axis.x());
  return {.all_constraint_m = solver.eigenvalues().sum(),
          .constraint_m = std::max(0.0, solver.eigenvalues()(0)),
          .direction_rad = direction_rad - kPi * std::floor(direction_rad / kPi)};
}

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

double overlap(const PreparedScan& reference, const PreparedScan& current, const Pose2& T) {
  constexpr double kOverlapTolerance_m = 0.2;
  const Evidence seen =
      align_one_way(reference.image, current.fine, T, kOverlapTolerance_m).evidence;
  return seen.wall_m > 0.0 ? seen.agreeing_m / seen.wall_m : 0.0;
}

/// Whether a different pose explains nearly as much and is contradicted no more. Its score may be
/// lower only because less is seen in common, which speaks for small motion, not against the pose.
bool has_rival(std::span<const Candidate> candidates, const AnswerParams& params) {
  const Candidate& best = candidates.front();
  const auto is_rival = [&](const Candidate& other) {
    return !are_same(best.T_reference_current, other.T_reference_current, params) &&
           other.evidence.agreeing_m >= params.rival_agreement * best.evidence.agreeing_m &&
           other.evidence.contradicted_m <= best.evidence.contradicted_m;
  };
  return std::any_of(candidates.begin() + 1, candidates.end(), is_rival);
}

bool stands(const MatchResult& result, double wall_m, const AnswerParams& params) {
  if (result.score < params.low_score && wall_m < params.min_wall_m) return false;
  // Without a runner-up nothing else was found at all: the margin is the score itself.
  const double margin = result.score - (result.runner_up ? result.runner_up->score : 0.0);
  return (result.score >= params.min_score && margin >= params.min_margin) ||
         (result.score >= params.min_score_alone && margin >= params.min_margin_alone);
}

MatchStatus judge(const MatchResult& result,
                  const WeakestDirection& weakest,
                  bool is_rivalled,
                  const AnswerParams& params) {
  if (!(result.agreement >= params.min_agreement)) return MatchStatus::kNoOverlap;
  if (weakest.constraint_m < params.min_constraint_m) return MatchStatus::kDegenerate;
  const bool is_alone = !is_rivalled && stands(result, weakest.all_constraint_m, params);
  return is_alone ? MatchStatus::kMatched : MatchStatus::kAmbiguous;
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
                   const MatchParams& params) {
  MatchResult result;
  if (candidates.empty()) {
    result.status = MatchStatus::kNoOverlap;
    return result;
  }
  const Candidate& best = candidates.front();
  for (const Candidate& other : candidates.subspan(1)) {
    if (are_same(best.T_reference_current, other.T_reference_current, params.answer)) continue;
    result.runner_up = RunnerUp{other.T_reference_current, other.score};
    break;
  }
  const Pose2 T = refine(reference.fine_alignment(),
                         current.fine_alignment(),
                         best.T_reference_current,
                         kFinalTolerances_m);
  const Eigen::Matrix3d hessian =
      align(reference.fine_alignment(), current.fine_alignment(), T, kFinalTolerance_m).hessian;
  const WeakestDirection weakest = weakest_direction(hessian);

  result.T_reference_current = T;
  result.information = hessian / (kCorrelationLength_m * kDistanceSigma_m * kDistanceSigma_m);
  const AxisZncc axes = axis_zncc(reference, current, T);
  result.zncc_x = axes.x;
  result.zncc_y = axes.y;
  result.score = best.score;
  result.agreement = best.evidence.agreeing_m / best.evidence.wall_m;
  result.contradiction = best.evidence.contradicted_m / best.evidence.wall_m;
  result.overlap = overlap(reference, current, T);
  result.status = judge(result, weakest, has_rival(candidates, params.answer), params.answer);
  if (result.status == MatchStatus::kDegenerate) {
    result.degenerate_direction_rad = weakest.direction_rad;
  }
  return result;
}

}  // namespace setsquare
