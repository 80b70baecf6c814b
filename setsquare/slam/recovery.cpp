// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/slam/recovery.hpp"

#include <cmath>

namespace setsquare {
namespace {

/// Refines from starts turned by -max_turn, -max_turn + step, ... max_turn; keeps the best score.
void try_turns(const TrackingProblem& problem,
               const Pose2& T_odom_last,
               double max_turn_rad,
               double step_rad,
               const SubmapRefinementParams& refinement,
               SubmapFit& best) {
  const int num_steps = static_cast<int>(std::floor(max_turn_rad / step_rad + 1e-9));
  for (int k = -num_steps; k <= num_steps; ++k) {
    Pose2 start = T_odom_last;
    start.theta_rad = wrap_to_pi(start.theta_rad + k * step_rad);
    const SubmapFit fit = refine_in_submap(problem, start, refinement);
    if (fit.alignment.score() > best.alignment.score()) best = fit;
  }
}

}  // namespace

std::optional<RecoveredFit> recover(const TrackingProblem& problem,
                                    const SubmapFit& tracked,
                                    const Pose2& T_odom_last,
                                    const RecoveryParams& params,
                                    const SubmapRefinementParams& refinement) {
  SubmapRefinementParams wide = refinement;
  wide.first_step = params.first_step;
  wide.max_iterations = params.max_iterations;

  SubmapFit best = tracked;
  try_turns(problem, T_odom_last, params.near_turn_rad, params.near_step_rad, wide, best);
  const double needed = tracked.alignment.score() + params.min_gain;
  if (best.alignment.score() >= params.far_below_score) {
    if (best.alignment.score() < needed) return std::nullopt;
    return RecoveredFit{best, false};
  }
  SubmapFit far = best;
  try_turns(problem, T_odom_last, kPi, params.far_step_rad, wide, far);
  if (far.alignment.score() >= std::max(needed, params.far_min_score)) {
    return RecoveredFit{far, true};
  }
  if (best.alignment.score() >= needed) return RecoveredFit{best, false};
  return std::nullopt;
}

}  // namespace setsquare
