// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/slam/submap_refinement.hpp"

#include <cmath>
#include <Eigen/Cholesky>

namespace setsquare {
namespace {

/// Keeps the normal equations solvable where no point binds anything (points x (1, m^2)).
constexpr double kDamping = 1e-3;

/// The Gauss-Newton step, with the prediction along the weak direction.
Eigen::Vector3d step_from(const SubmapFit& fit,
                          const TrackingProblem& problem,
                          const SubmapRefinementParams& params) {
  Eigen::Matrix3d hessian = fit.alignment.hessian + kDamping * Eigen::Matrix3d::Identity();
  Eigen::Vector3d gradient = fit.alignment.gradient;
  const double missing_points = params.min_effective_points - fit.weak.effective_points;
  if (missing_points > 0.0) {
    const double weight = problem.trust.weight * missing_points;
    const Eigen::Vector2d& u = fit.weak.direction;
    const Eigen::Vector2d off =
        fit.T_odom_sensor.translation() - problem.T_odom_predicted.translation();
    hessian.topLeftCorner<2, 2>() += weight * u * u.transpose();
    gradient.head<2>() += weight * u.dot(off) * u;
  }
  Eigen::Vector3d step = hessian.ldlt().solve(-gradient);
  const double length_m = step.head<2>().norm();
  if (length_m > params.max_step_m) step.head<2>() *= params.max_step_m / length_m;
  return step;
}

}  // namespace

SubmapFit refine_in_submap(const TrackingProblem& problem,
                           const Pose2& start,
                           const SubmapRefinementParams& params) {
  SubmapFit fit{.T_odom_sensor = start, .alignment = {}, .weak = {}};
  Pose2 T = start;
  for (int iteration = 0; iteration < params.max_iterations; ++iteration) {
    const AlignmentScale& scale = iteration == 0 ? params.first_step : params.later_steps;
    fit.T_odom_sensor = T;
    fit.alignment = align_with_submap(problem.submap, problem.points, T, scale, problem.marks);
    fit.weak = weak_direction(fit.alignment.hessian.topLeftCorner<2, 2>());
    const Eigen::Vector3d step = step_from(fit, problem, params);
    T = {T.x_m + step.x(), T.y_m + step.y(), wrap_to_pi(T.theta_rad + step.z())};
    if (step.head<2>().norm() < params.converged_m && std::abs(step.z()) < params.converged_rad) {
      break;
    }
  }
  fit.T_odom_sensor = T;
  return fit;
}

}  // namespace setsquare
