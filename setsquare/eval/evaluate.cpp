// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/evaluate.hpp"

#include "setsquare/core/error.hpp"

namespace setsquare {

AbsoluteTrajectoryError evaluate(const Trajectory& trajectory,
                                 const Trajectory& truth,
                                 const std::optional<BootstrapParams>& bootstrap) {
  const PairedPoses paired = pair_poses(trajectory, truth, 1e-9 * kSameStamp_ns);
  if (paired.pairs.empty()) throw ParameterError("truth", "has no pose at any of the stamps");
  return absolute_trajectory_error(paired.pairs, TrajectoryAlignment::kBest, bootstrap);
}

RelationErrorReport evaluate(const Trajectory& trajectory,
                             std::span<const Relation> relations,
                             const std::optional<BootstrapParams>& bootstrap) {
  return relation_error(trajectory, relations, bootstrap);
}

}  // namespace setsquare
