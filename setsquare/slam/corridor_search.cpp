// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/slam/corridor_search.hpp"

#include <cmath>

namespace setsquare {
namespace {

Pose2 moved(const Pose2& T, const Eigen::Vector2d& direction, double by_m) {
  return {T.x_m + by_m * direction.x(), T.y_m + by_m * direction.y(), T.theta_rad};
}

/// Closeness less what the motion costs.
class CorridorScore {
 public:
  CorridorScore(const TrackingProblem& problem,
                const Eigen::Vector2d& direction,
                const CorridorSearchParams& params)
      : problem_(problem), direction_(direction), params_(params) {}

  double off_prediction_m(const Pose2& T) const {
    return direction_.dot(T.translation() - problem_.T_odom_predicted.translation());
  }

  double operator()(const Pose2& T) const {
    const double sigmas = off_prediction_m(T) / problem_.trust.sigma_m;
    return closeness_to_submap(problem_.submap, problem_.points, T, params_.scale_m) -
           params_.motion_cost * sigmas * sigmas;
  }

 private:
  const TrackingProblem& problem_;
  Eigen::Vector2d direction_;
  const CorridorSearchParams& params_;
};

}  // namespace

SubmapFit search_along_corridor(const TrackingProblem& problem,
                                const SubmapFit& fit,
                                const CorridorSearchParams& params,
                                const SubmapRefinementParams& refinement) {
  const Eigen::Vector2d direction = fit.weak.direction;
  const CorridorScore score(problem, direction, params);
  const Pose2 at_prediction =
      moved(fit.T_odom_sensor, direction, -score.off_prediction_m(fit.T_odom_sensor));
  const int num_steps = static_cast<int>(std::lround(params.half_range_m / params.step_m));
  Pose2 best = at_prediction;
  double best_score = -1e9;
  for (int k = -num_steps; k <= num_steps; ++k) {
    const Pose2 candidate = moved(at_prediction, direction, k * params.step_m);
    const double candidate_score = score(candidate);
    if (candidate_score <= best_score) continue;
    best = candidate;
    best_score = candidate_score;
  }
  const double fit_score = score(fit.T_odom_sensor);
  if (best_score <= fit_score + problem.trust.min_gain) return fit;

  SubmapRefinementParams settle = refinement;
  settle.first_step = refinement.later_steps;
  const TrackingProblem from_best{
      problem.submap, problem.points, best, problem.trust, problem.marks};
  const SubmapFit found = refine_in_submap(from_best, best, settle);
  return score(found.T_odom_sensor) > fit_score + problem.trust.min_gain ? found : fit;
}

}  // namespace setsquare
