// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/submap_answer.hpp"

namespace setsquare {

bool is_open(const SubmapFit& fit, const SubmapRefinementParams& params) {
  return fit.open.effective_points < params.min_effective_points || fit.turn.bound_share < 1.0;
}

TrackedPose answer_of(const SubmapFit& fit, const SubmapRefinementParams& params) {
  TrackedPose tracked{
      .status = is_open(fit, params) ? TrackStatus::kDegenerate : TrackStatus::kTracked,
      .T_odom_sensor = fit.T_odom_sensor,
      .score = fit.alignment.score(),
      .open = fit.open,
      .open_bound_share = params.bound_share(fit.open.effective_points),
      .turn_bound_share = fit.turn.bound_share};
  const double lever_m = fit.turn.motion_m.norm();
  if (fit.turn.bound_share < 1.0 && lever_m > 0.0) {
    tracked.open.direction = fit.turn.motion_m / lever_m;
    tracked.open_bound_share = fit.turn.bound_share;
    tracked.turn_motion_m = fit.turn.motion_m;
  }
  return tracked;
}

}  // namespace setsquare
