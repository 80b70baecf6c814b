// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/open_turn.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>

#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/core/pose2.hpp"

namespace setsquare {

void OpenTurnParams::validate() const {
  require_finite(min_score, "refinement.turn.min_score");
  require_not_negative(noise_rad, "refinement.turn.noise_rad");
  if (!(bound_rad > noise_rad)) {
    throw ParameterError("refinement.turn.bound_rad", "must be above noise_rad");
  }
}

OpenTurn least_bound_turn(const Eigen::Matrix3d& hessian) {
  const Eigen::Vector2d coupling = hessian.topRightCorner<2, 1>();
  OpenTurn turn;
  turn.motion_m = -(hessian.topLeftCorner<2, 2>().inverse() * coupling);
  turn.information_m2 = hessian(2, 2) + coupling.dot(turn.motion_m);
  return turn;
}

OpenTurn open_turn(const SubmapAlignment& alignment,
                   const SurfaceSamples& points,
                   const PointMarks& marks,
                   double heading_rad,
                   const OpenTurnParams& params) {
  OpenTurn turn = least_bound_turn(alignment.hessian);
  if (alignment.score() < params.min_score) return turn;
  const Eigen::Vector2d to_centre_m =
      rotation_matrix(-heading_rad) * Eigen::Vector2d(-turn.motion_m.y(), turn.motion_m.x());
  double sum_m2 = 0.0;
  double num_explained = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_explained(marks[i])) continue;
    const Eigen::Vector2d from_centre_m =
        Eigen::Vector2d(points.x_m[i], points.y_m[i]) - to_centre_m;
    const double facing_m =
        from_centre_m.x() * points.normal_x[i] + from_centre_m.y() * points.normal_y[i];
    sum_m2 += facing_m * facing_m;
    num_explained += 1.0;
  }
  if (num_explained == 0.0) return turn;
  const double num_points = alignment.hessian.topLeftCorner<2, 2>().trace();
  const double per_square_rad = num_points * sum_m2 / num_explained;
  const double noise_m2 = params.noise_rad * params.noise_rad * per_square_rad;
  const double bound_m2 = params.bound_rad * params.bound_rad * per_square_rad;
  if (turn.information_m2 < bound_m2) {
    turn.bound_share = std::max(0.0, (turn.information_m2 - noise_m2) / (bound_m2 - noise_m2));
  }
  return turn;
}

}  // namespace setsquare
