// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/absolute_trajectory_error.hpp"

#include <cassert>
#include <cmath>
#include <vector>

#include "setsquare/eval/rigid_alignment.hpp"

namespace setsquare {
namespace {

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

AbsoluteTrajectoryError absolute_trajectory_error(std::span<const PosePair> pairs,
                                                  TrajectoryAlignment alignment) {
  assert(!pairs.empty());
  AbsoluteTrajectoryError error;
  error.T_truth_map = align(pairs, alignment);
  std::vector<double> translation_m;
  std::vector<double> rotation_rad;
  for (const PosePair& pair : pairs) {
    const Pose2 aligned = error.T_truth_map * pair.T_map_base;
    translation_m.push_back((aligned.translation() - pair.T_truth_base.translation()).norm());
    rotation_rad.push_back(std::abs(wrap_to_pi(aligned.theta_rad - pair.T_truth_base.theta_rad)));
  }
  error.final_translation_m = translation_m.back();
  error.final_rotation_rad = rotation_rad.back();
  error.translation_m = error_statistics(translation_m);
  error.rotation_rad = error_statistics(rotation_rad);
  return error;
}

}  // namespace setsquare
