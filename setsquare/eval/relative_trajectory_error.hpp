// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "setsquare/eval/bootstrap.hpp"
#include "setsquare/eval/error_series.hpp"
#include "setsquare/eval/error_statistics.hpp"
#include "setsquare/eval/pose_pairs.hpp"

namespace setsquare {

/// In what the span of one relative motion is counted.
enum class RelativeSpan {
  kDistance,  ///< m along the reference's path, its poses taken in the order of their stamps.
  kTime,      ///< s of the reference's stamps.
  kPoses,     ///< Pairs of poses.
};

/// Over what spans the relative error is taken.
struct RelativeErrorParams {
  RelativeSpan span = RelativeSpan::kDistance;  ///< What a span's length is counted in.
  double length = 1.0;                          ///< Of the span, in its unit; positive.

  /// Throws ParameterError where the length is not positive and finite.
  void validate() const;
};

/// How far the motions over spans are from the true ones.
struct RelativeTrajectoryError {
  ErrorStatistics translation_m;  ///< Of |trans(E)|, in m.
  ErrorStatistics rotation_rad;   ///< Of |rot(E)|, in rad.
  std::size_t num_left_out = 0;   ///< Spans of more than 1.5 times the length: a gap in the pairs.
};

/// The relative trajectory error (RPE; Sturm et al. 2012): from every pair i to the first pair j
/// that is at least the length away, with E = (T_truth_i^-1 T_truth_j)^-1 (T_map_i^-1 T_map_j), the
/// statistics of |trans(E)| and |rot(E)|. Pairs are ordered by their stamps. With bounds where they
/// are asked for.
[[nodiscard]] RelativeTrajectoryError relative_trajectory_error(
    std::span<const PosePair> pairs,
    const RelativeErrorParams& params = {},
    const std::optional<BootstrapParams>& bootstrap = std::nullopt);

/// The errors of the spans, each with the stamp of its first pair, and the spans left out.
struct RelativeErrors {
  ErrorSeries errors;            ///< |trans(E)| and |rot(E)|.
  std::size_t num_left_out = 0;  ///< As RelativeTrajectoryError has it.
};
/// What relative_trajectory_error() sums up.
[[nodiscard]] RelativeErrors relative_errors(std::span<const PosePair> pairs,
                                             const RelativeErrorParams& params = {});

}  // namespace setsquare
