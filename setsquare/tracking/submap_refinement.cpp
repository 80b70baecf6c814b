// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/submap_refinement.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/core/damped_step.hpp"

namespace setsquare {
namespace {

/// Keeps the normal equations solvable where no point binds anything (points x (1, m^2)).
constexpr double kStepDamping = 1e-3;

/// Takes out what binds the turn by chance, and puts the prediction in its place.
void turn_as_predicted(const SubmapFit& fit,
                       const TrackingProblem& problem,
                       NormalEquations<3>& walls,
                       NormalEquations<3>& prediction) {
  const OpenTurn& turn = fit.turn;
  const double open_share = 1.0 - turn.bound_share;
  const Eigen::Vector3d motion(turn.motion_m.x(), turn.motion_m.y(), 1.0);
  walls.hessian(2, 2) -= open_share * turn.information_m2;
  walls.gradient.z() -= open_share * motion.dot(walls.gradient);
  const double weight = open_share * problem.trust.weight * fit.alignment.hessian(2, 2);
  const double off_rad =
      wrap_to_pi(fit.T_odom_sensor.theta_rad - problem.T_odom_predicted.theta_rad);
  prediction.hessian(2, 2) += weight;
  prediction.gradient.z() += weight * off_rad;
}

/// The Gauss-Newton step, with the prediction along the open direction.
Eigen::Vector3d step_from(const SubmapFit& fit,
                          const TrackingProblem& problem,
                          const SubmapRefinementParams& params) {
  // What binds the open direction by chance is taken out: a robot in a bare corridor would come to
  // rest.
  const Eigen::Matrix3d kept =
      keeping_open_share(fit.open, params.bound_share(fit.open.effective_points));
  NormalEquations<3> prediction;
  const double missing_points = params.min_effective_points - fit.open.effective_points;
  if (missing_points > 0.0) {
    const double weight = problem.trust.weight * missing_points;
    const Eigen::Vector2d& u = fit.open.direction;
    const Eigen::Vector2d off =
        fit.T_odom_sensor.translation() - problem.T_odom_predicted.translation();
    prediction.hessian.topLeftCorner<2, 2>() = weight * u * u.transpose();
    prediction.gradient.head<2>() = weight * u.dot(off) * u;
  }
  NormalEquations<3> walls{kept * fit.alignment.hessian * kept, kept * fit.alignment.gradient};
  if (fit.turn.bound_share < 1.0) turn_as_predicted(fit, problem, walls, prediction);
  Eigen::Vector3d step = damped_step(walls, kStepDamping, prediction);
  const double length_m = step.head<2>().norm();
  if (length_m > params.max_step_m) step.head<2>() *= params.max_step_m / length_m;
  return step;
}

Pose2 moved(const Pose2& T, const Eigen::Vector2d& direction, double by_m) {
  return {T.x_m + by_m * direction.x(), T.y_m + by_m * direction.y(), T.theta_rad};
}

/// The iteration; the walls bind the turn by this share.
SubmapFit refine(const TrackingProblem& problem,
                 const Pose2& start,
                 const SubmapRefinementParams& params,
                 double turn_bound_share) {
  SubmapFit fit{.T_odom_sensor = start, .alignment = {}, .open = {}, .turn = {}};
  Pose2 T = start;
  for (int iteration = 0; iteration < params.max_iterations; ++iteration) {
    const AlignmentScale& scale = iteration == 0 ? params.first_step : params.later_steps;
    fit.T_odom_sensor = T;
    fit.alignment = align_with_submap(problem.submap, problem.points, T, scale, problem.marks);
    fit.open = open_direction(fit.alignment.hessian.topLeftCorner<2, 2>());
    if (turn_bound_share < 1.0) {
      fit.turn = least_bound_turn(fit.alignment.hessian);
      fit.turn.bound_share = turn_bound_share;
    }
    const Eigen::Vector3d step = step_from(fit, problem, params);
    T = stepped(T, step);
    if (step.head<2>().norm() < params.converged_m && std::abs(step.z()) < params.converged_rad) {
      break;
    }
  }
  fit.T_odom_sensor = T;
  return fit;
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

SubmapFit refine_in_submap(const TrackingProblem& problem,
                           const Pose2& start,
                           const SubmapRefinementParams& params) {
  SubmapFit fit = refine(problem, start, params, 1.0);
  if (fit.open.effective_points < params.min_effective_points) return fit;
  const OpenTurn turn = open_turn(
      fit.alignment, problem.points, problem.marks, fit.T_odom_sensor.theta_rad, params.turn);
  if (turn.bound_share < 1.0) fit = refine(problem, start, params, turn.bound_share);
  return fit;
}

SubmapFit search_along_corridor(const TrackingProblem& problem,
                                const SubmapFit& fit,
                                const CorridorSearchParams& params,
                                const SubmapRefinementParams& refinement) {
  const Eigen::Vector2d direction = fit.open.direction;
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
