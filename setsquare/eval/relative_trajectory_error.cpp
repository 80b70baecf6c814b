// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/relative_trajectory_error.hpp"

#include <cmath>
#include <vector>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

/// A span may be longer than it should be by this factor: poses come one by one.
constexpr double kMaxStretch = 1.5;

/// Absorbs rounding where the sum of steps should be the length exactly.
constexpr double kRelativeRounding = 1e-9;

/// How far each pair is from the first, in the span's unit: a sequence that never falls.
std::vector<double> positions_along(std::span<const PosePair> pairs, RelativeSpan span) {
  std::vector<double> positions;
  double distance_m = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (i > 0) {
      distance_m +=
          (pairs[i].T_truth_base.translation() - pairs[i - 1].T_truth_base.translation()).norm();
    }
    switch (span) {
      case RelativeSpan::kDistance:
        positions.push_back(distance_m);
        break;
      case RelativeSpan::kTime:
        positions.push_back(seconds_between(pairs.front().stamp, pairs[i].stamp));
        break;
      case RelativeSpan::kPoses:
        positions.push_back(static_cast<double>(i));
        break;
    }
  }
  return positions;
}

}  // namespace

void RelativeErrorParams::validate() const {
  if (!(length > 0.0) || !std::isfinite(length)) throw ParameterError("length", "must be positive");
}

RelativeErrors relative_errors(std::span<const PosePair> pairs, const RelativeErrorParams& params) {
  params.validate();
  const std::vector<double> positions = positions_along(pairs, params.span);
  const double least = params.length * (1.0 - kRelativeRounding);
  RelativeErrors found;
  std::size_t j = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    while (j < pairs.size() && positions[j] - positions[i] < least) ++j;
    if (j == pairs.size()) break;
    if (positions[j] - positions[i] > kMaxStretch * params.length) {
      ++found.num_left_out;
      continue;
    }
    const Pose2 T_true = pairs[i].T_truth_base.inverse() * pairs[j].T_truth_base;
    const Pose2 T_judged = pairs[i].T_map_base.inverse() * pairs[j].T_map_base;
    const Pose2 difference = T_true.inverse() * T_judged;
    found.errors.stamps.push_back(pairs[i].stamp);
    found.errors.translation_m.push_back(difference.translation().norm());
    found.errors.rotation_rad.push_back(std::abs(wrap_to_pi(difference.theta_rad)));
  }
  return found;
}

RelativeTrajectoryError relative_trajectory_error(std::span<const PosePair> pairs,
                                                  const RelativeErrorParams& params,
                                                  const std::optional<BootstrapParams>& bootstrap) {
  const RelativeErrors found = relative_errors(pairs, params);
  return {error_statistics(found.errors.translation_m, bootstrap),
          error_statistics(found.errors.rotation_rad, bootstrap),
          found.num_left_out};
}

}  // namespace setsquare
