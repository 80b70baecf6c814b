// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "setsquare/eval/bootstrap.hpp"
#include "setsquare/eval/error_series.hpp"
#include "setsquare/eval/error_statistics.hpp"
#include "setsquare/eval/pose_pairs.hpp"

namespace setsquare {
/// T_truth_map that lays the positions of a trajectory onto their reference with the least sum of
/// squared distances: Umeyama 1991 in the plane, without scale. Where positions do not determine
/// the rotation (the robot stood still, or there is one pose only) the mean difference of the
/// headings does. The identity for no pair.
[[nodiscard]] Pose2 best_rigid_alignment(std::span<const PosePair> pairs);

/// How a trajectory is laid onto its reference before it is judged.
enum class TrajectoryAlignment {
  kBest,   ///< The rigid motion of the least squared distances: best_rigid_alignment().
  kFirst,  ///< The first poses in time agree.
  kNone,   ///< Both are in one frame already.
};

/// How far a trajectory as a whole is from the true one.
struct AbsoluteTrajectoryError {
  Pose2 T_truth_map;                 ///< The alignment.
  ErrorStatistics translation_m;     ///< Distances of the aligned positions.
  ErrorStatistics rotation_rad;      ///< Differences of the aligned headings, wrapped, absolute.
  double final_translation_m = 0.0;  ///< Of the last pair.
  double final_rotation_rad = 0.0;   ///< Of the last pair.
};

/// The absolute trajectory error (ATE; Sturm et al. 2012) over the pairs, of which there is at
/// least one, in the order of their stamps; with bounds where they are asked for.
[[nodiscard]] AbsoluteTrajectoryError absolute_trajectory_error(
    std::span<const PosePair> pairs,
    TrajectoryAlignment alignment,
    const std::optional<BootstrapParams>& bootstrap = std::nullopt);

/// The errors of the aligned poses, one per pair.
[[nodiscard]] ErrorSeries absolute_errors(std::span<const PosePair> pairs,
                                          const Pose2& T_truth_map);

}  // namespace setsquare
