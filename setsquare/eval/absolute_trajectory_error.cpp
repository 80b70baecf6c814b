// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/absolute_trajectory_error.hpp"

#include <cassert>
#include <cmath>
#include <Eigen/Core>
#include <vector>

namespace setsquare {
namespace {

/// Positions that vary by less than this, root mean square, are one place.
constexpr double kStandstill_m = 1e-3;

double mean_heading_difference(std::span<const PosePair> pairs) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const PosePair& pair : pairs) {
    const double difference_rad = pair.T_truth_base.theta_rad - pair.T_map_base.theta_rad;
    sum += Eigen::Vector2d(std::cos(difference_rad), std::sin(difference_rad));
  }
  return std::atan2(sum.y(), sum.x());
}

Pose2 align(std::span<const PosePair> pairs, TrajectoryAlignment alignment) {
  switch (alignment) {
    case TrajectoryAlignment::kBest:
      return best_rigid_alignment(pairs);
    case TrajectoryAlignment::kFirst:
      return pairs.front().T_truth_base * pairs.front().T_map_base.inverse();
    case TrajectoryAlignment::kNone:
      break;
  }
  return {};
}

}  // namespace

Pose2 best_rigid_alignment(std::span<const PosePair> pairs) {
  if (pairs.empty()) return {};
  const auto num_pairs = static_cast<double>(pairs.size());
  Eigen::Vector2d mean_map = Eigen::Vector2d::Zero();
  Eigen::Vector2d mean_truth = Eigen::Vector2d::Zero();
  for (const PosePair& pair : pairs) {
    mean_map += pair.T_map_base.translation() / num_pairs;
    mean_truth += pair.T_truth_base.translation() / num_pairs;
  }
  // In the plane the rotation of Umeyama 1991 is the angle of the complex correlation of the two
  // sets of positions about their means.
  double along = 0.0;
  double across = 0.0;
  for (const PosePair& pair : pairs) {
    const Eigen::Vector2d map = pair.T_map_base.translation() - mean_map;
    const Eigen::Vector2d truth = pair.T_truth_base.translation() - mean_truth;
    along += map.dot(truth);
    across += map.x() * truth.y() - map.y() * truth.x();
  }
  const bool is_standstill = std::hypot(along, across) < num_pairs * kStandstill_m * kStandstill_m;
  const double rotation_rad =
      is_standstill ? mean_heading_difference(pairs) : std::atan2(across, along);
  const Eigen::Vector2d turned = Pose2{0.0, 0.0, rotation_rad} * mean_map;
  return {mean_truth.x() - turned.x(), mean_truth.y() - turned.y(), wrap_to_pi(rotation_rad)};
}

ErrorSeries absolute_errors(std::span<const PosePair> pairs, const Pose2& T_truth_map) {
  ErrorSeries errors;
  for (const PosePair& pair : pairs) {
    const Pose2 aligned = T_truth_map * pair.T_map_base;
    errors.stamps.push_back(pair.stamp);
    errors.translation_m.push_back(
        (aligned.translation() - pair.T_truth_base.translation()).norm());
    errors.rotation_rad.push_back(
        std::abs(wrap_to_pi(aligned.theta_rad - pair.T_truth_base.theta_rad)));
  }
  return errors;
}

AbsoluteTrajectoryError absolute_trajectory_error(std::span<const PosePair> pairs,
                                                  TrajectoryAlignment alignment,
                                                  const std::optional<BootstrapParams>& bootstrap) {
  assert(!pairs.empty());
  AbsoluteTrajectoryError error;
  error.T_truth_map = align(pairs, alignment);
  const ErrorSeries errors = absolute_errors(pairs, error.T_truth_map);
  error.final_translation_m = errors.translation_m.back();
  error.final_rotation_rad = errors.rotation_rad.back();
  error.translation_m = error_statistics(errors.translation_m, bootstrap);
  error.rotation_rad = error_statistics(errors.rotation_rad, bootstrap);
  return error;
}

}  // namespace setsquare
