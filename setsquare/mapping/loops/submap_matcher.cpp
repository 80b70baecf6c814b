// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/loops/submap_matcher.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "setsquare/core/damped_step.hpp"
#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/core/sort_by.hpp"

namespace setsquare {
namespace {

/// Keeps the normal equations solvable where no point binds anything (points x (1, m^2)).
constexpr double kSubmapDamping = 1e-3;
constexpr double kMaxStep_m = 0.3;
constexpr double kConverged = 1e-3;
/// Proposals come in cells, and a refined pose may leave the window by a little.
constexpr double kWindowMargin_m = 0.25;

/// d (x, y, theta) of T^-1 / d (x, y, theta) of T.
Eigen::Matrix3d inverse_derivative(const Pose2& T) {
  const double c = std::cos(T.theta_rad);
  const double s = std::sin(T.theta_rad);
  Eigen::Matrix3d J;
  J << -c, -s, s * T.x_m - c * T.y_m,  //
      s, -c, c * T.x_m + s * T.y_m,    //
      0.0, 0.0, -1.0;
  return J;
}

/// Which of a submap's samples.
using Samples = SurfaceSamples Submap::*;

/// Compares two submaps and moves one until they agree.
class Comparison {
 public:
  Comparison(const Submap& reference,
             const Submap& current,
             const ExpectedPose& expected,
             const SubmapMatchParams& params)
      : reference_(reference), current_(current), expected_(expected), params_(params) {}

  /// Steps on from a fit of the same samples at the same scale.
  [[nodiscard]] SubmapFitBothWays refine(SubmapFitBothWays fit,
                                         const AlignmentScale& scale,
                                         int num_steps,
                                         Samples samples) {
    for (int step = 0; step < num_steps; ++step) {
      const Eigen::Vector3d move = step_from(fit);
      fit = compare(stepped(fit.T_reference_current, move), scale, samples);
      if (move.norm() < kConverged) break;
    }
    return fit;
  }

  [[nodiscard]] SubmapFitBothWays compare(const Pose2& T,
                                          const AlignmentScale& scale,
                                          Samples samples) {
    const SubmapAlignment forward =
        align_with_submap(reference_.images, current_.*samples, T, scale, marks_);
    const SubmapAlignment backward =
        align_with_submap(current_.images, reference_.*samples, T.inverse(), scale, marks_);
    const Eigen::Matrix3d J = inverse_derivative(T);
    SubmapFitBothWays fit;
    fit.T_reference_current = T;
    fit.hessian = forward.hessian + J.transpose() * backward.hessian * J;
    fit.gradient = forward.gradient + J.transpose() * backward.gradient;
    const double compared = forward.num_compared + backward.num_compared;
    const double explained = forward.num_explained + backward.num_explained;
    const double contradicted = forward.num_contradicted + backward.num_contradicted;
    const auto total =
        static_cast<double>((current_.*samples).size() + (reference_.*samples).size());
    const double least = std::max(1.0, params_.min_compared * total);
    const double gain = explained - params_.contradiction_weight * contradicted;
    fit.score = gain / std::max(compared, least);
    fit.agreement = gain / std::max(explained + contradicted, least);
    fit.contradiction = contradicted / std::max(1.0, explained + contradicted);
    return fit;
  }

  [[nodiscard]] bool is_in_window(const Pose2& T) const {
    const Eigen::Vector2d off = T.translation() - expected_.T_reference_current.translation();
    return off.cwiseAbs().maxCoeff() <= expected_.window_m + kWindowMargin_m;
  }

 private:
  /// The Gauss-Newton step, the rotation held near the expected one.
  [[nodiscard]] Eigen::Vector3d step_from(const SubmapFitBothWays& fit) const {
    NormalEquations<3> heading;
    heading.hessian(2, 2) = params_.heading_weight;
    heading.gradient(2) =
        params_.heading_weight *
        wrap_to_pi(fit.T_reference_current.theta_rad - expected_.T_reference_current.theta_rad);
    Eigen::Vector3d step = damped_step({fit.hessian, fit.gradient}, kSubmapDamping, heading);
    const double length_m = step.head<2>().norm();
    if (length_m > kMaxStep_m) step.head<2>() *= kMaxStep_m / length_m;
    return step;
  }

  const Submap& reference_;
  const Submap& current_;
  const ExpectedPose& expected_;
  const SubmapMatchParams& params_;
  PointMarks marks_;
};

/// Where refinement may begin: the expected pose and the best proposals.
std::vector<Pose2> propose(const Submap& reference,
                           const Submap& current,
                           const ExpectedPose& expected,
                           const Comparison& comparison,
                           const SubmapMatchParams& params) {
  std::vector<TranslationProposal> proposals;
  correlation_grid(reference).propose_translations(
      current.coarse, expected.T_reference_current, params.min_correlation, proposals);
  std::erase_if(proposals, [&](const TranslationProposal& proposal) {
    return !comparison.is_in_window(proposal.T_reference_current);
  });
  std::stable_sort(proposals.begin(), proposals.end(), [](const auto& a, const auto& b) {
    return a.correlation > b.correlation;
  });
  if (proposals.size() > params.max_num_proposals) proposals.resize(params.max_num_proposals);
  std::vector<Pose2> starts = {expected.T_reference_current};
  for (const TranslationProposal& proposal : proposals) {
    starts.push_back(proposal.T_reference_current);
  }
  return starts;
}

/// Leaves those that neither score nor agree within `max_lag` of what the best does.
std::vector<SubmapFitBothWays> without_laggards(std::vector<SubmapFitBothWays> fits,
                                                double max_lag) {
  double best_score = -1.0;
  double best_agreement = -1.0;
  for (const SubmapFitBothWays& fit : fits) {
    best_score = std::max(best_score, fit.score);
    best_agreement = std::max(best_agreement, fit.agreement);
  }
  std::erase_if(fits, [&](const SubmapFitBothWays& fit) {
    return fit.score < best_score - max_lag && fit.agreement < best_agreement - max_lag;
  });
  return fits;
}

/// The starts caught by their surroundings, the best by score first; nothing where none of them
/// is promising: views of other things hardly agree anywhere.
std::vector<SubmapFitBothWays> caught(const std::vector<Pose2>& starts,
                                      Comparison& comparison,
                                      const SubmapMatchParams& params) {
  std::vector<SubmapFitBothWays> fits;
  bool is_promising = false;
  for (const Pose2& start : starts) {
    fits.push_back(comparison.compare(start, params.catching, &Submap::rough));
    is_promising = is_promising || fits.back().score >= params.min_start_score;
  }
  if (!is_promising) return {};
  const auto step_on = [&](int num_steps) {
    for (SubmapFitBothWays& fit : fits) {
      fit = comparison.refine(fit, params.catching, num_steps, &Submap::rough);
    }
  };
  step_on(1);
  fits = without_laggards(std::move(fits), params.max_lag);
  step_on(params.num_catching_steps - 1);
  std::erase_if(fits, [&](const SubmapFitBothWays& fit) {
    return !comparison.is_in_window(fit.T_reference_current);
  });
  sort_by_greatest(fits, &SubmapFitBothWays::score);
  return fits;
}

/// The best that stays within the window while it settles. `fits`: best first.
std::optional<SubmapFitBothWays> settle_best(const std::vector<SubmapFitBothWays>& fits,
                                             Comparison& comparison,
                                             const SubmapMatchParams& params) {
  for (const SubmapFitBothWays& fit : fits) {
    const auto settled = comparison.refine(
        comparison.compare(fit.T_reference_current, params.settling, &Submap::fine),
        params.settling,
        params.num_settling_steps,
        &Submap::fine);
    if (comparison.is_in_window(settled.T_reference_current)) return settled;
  }
  return std::nullopt;
}

double distance_m(const SubmapFitBothWays& a, const SubmapFitBothWays& b) {
  return (a.T_reference_current.translation() - b.T_reference_current.translation()).norm();
}

}  // namespace

void SubmapMatchParams::validate() const {
  require_at_least_one(max_num_proposals, "match.max_num_proposals");
  require_finite(min_start_score, "match.min_start_score");
  require_positive(max_lag, "match.max_lag");
  catching.validate("match.catching");
  settling.validate("match.settling");
  require_at_least_one(num_catching_steps, "match.num_catching_steps");
  require_at_least_one(num_settling_steps, "match.num_settling_steps");
  require_not_negative(heading_weight, "match.heading_weight");
  require_not_negative(contradiction_weight, "match.contradiction_weight");
  require_positive(min_compared, "match.min_compared");
  require_positive(distinct_m, "match.distinct_m");
}

std::optional<SubmapMatch> match_submaps(const Submap& reference,
                                         const Submap& current,
                                         const ExpectedPose& expected,
                                         const SubmapMatchParams& params) {
  Comparison comparison(reference, current, expected, params);
  std::vector<SubmapFitBothWays> fits =
      caught(propose(reference, current, expected, comparison, params), comparison, params);
  const auto settled = settle_best(fits, comparison, params);
  if (!settled) return std::nullopt;

  SubmapMatch match;
  match.best = *settled;
  match.open = open_direction(match.best.hessian.topLeftCorner<2, 2>());
  std::erase_if(fits, [&](const SubmapFitBothWays& fit) {
    return distance_m(fit, match.best) < params.distinct_m;
  });
  match.others = std::move(fits);
  return match;
}

}  // namespace setsquare
