// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/sudden_turn.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/core/angle.hpp"
#include "setsquare/surfaces/surface_points.hpp"
#include "setsquare/surfaces/surface_samples.hpp"
#include "setsquare/tracking/submap_alignment.hpp"

namespace setsquare {

SuddenTurn find_sudden_turn(const UnexpectedScan& unexpected,
                            std::span<const PlacedImage> submap,
                            const SurfaceParams& surfaces,
                            const SuddenTurnParams& params) {
  // However long it took: stamps and sweep times may be absurd.
  const auto num_steps = [&](double time_s, double max_rad) {
    const double turn_rad = std::min(params.fastest_rad_per_s * std::abs(time_s), max_rad);
    return static_cast<int>(std::ceil(turn_rad / params.step_rad));
  };
  const int num_in_sweep = num_steps(unexpected.sweep_s, kTwoPi);
  const int num_since_last = num_steps(unexpected.elapsed_s, kPi);  // Others look the same.
  SuddenTurn best{{}, unexpected.T_odom_last};
  double best_closeness = -1.0;
  for (int in_sweep = -num_in_sweep; in_sweep <= num_in_sweep; ++in_sweep) {
    const double half_rad = 0.5 * params.step_rad * in_sweep;
    const SweepMotion motion{{0.0, 0.0}, half_rad, half_rad};
    const Scan flat = deskewed(unexpected.scan, motion, surfaces).scan;
    const SurfaceSamples samples =
        sample_surface(surface_points_from_scan(flat, surfaces), params.max_samples);
    for (int since_last = -num_since_last; since_last <= num_since_last; ++since_last) {
      const Pose2 T = unexpected.T_odom_last * Pose2{0.0, 0.0, params.step_rad * since_last};
      const double closeness = closeness_to_submap(submap, samples, T, params.scale_m);
      if (closeness <= best_closeness) continue;
      best_closeness = closeness;
      best = {motion, T};
    }
  }
  return best;
}

}  // namespace setsquare
