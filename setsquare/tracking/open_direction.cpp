// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/open_direction.hpp"

#include <cmath>

namespace setsquare {

OpenDirection open_direction(const Eigen::Matrix2d& information_points) {
  const double half_difference = 0.5 * (information_points(0, 0) - information_points(1, 1));
  const double off_diagonal = information_points(0, 1);
  const double radius = std::hypot(half_difference, off_diagonal);
  const double strong_rad = 0.5 * std::atan2(off_diagonal, half_difference);
  return {.direction = {-std::sin(strong_rad), std::cos(strong_rad)},
          .effective_points = 0.5 * information_points.trace() - radius};
}

Eigen::Matrix3d keeping_open_share(const OpenDirection& open, double share) {
  Eigen::Matrix3d kept = Eigen::Matrix3d::Identity();
  kept.topLeftCorner<2, 2>() -=
      (1.0 - std::sqrt(share)) * open.direction * open.direction.transpose();
  return kept;
}

}  // namespace setsquare
