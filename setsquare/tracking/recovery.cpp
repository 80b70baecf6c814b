// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/recovery.hpp"

#include <algorithm>

#include "setsquare/core/is_beyond.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"
#include "setsquare/tracking/known_place.hpp"

namespace setsquare {
namespace {

bool is_far_from(const Pose2& expected, const Pose2& found, const RecoveryParams& params) {
  return is_beyond(expected.inverse() * found, params.near_m, params.near_rad);
}

}  // namespace

std::optional<RecoveredFit> recover(const TrackingProblem& problem,
                                    std::span<const KeyframePtr> keyframes,
                                    const ScanSurfacesPtr& surfaces,
                                    const std::optional<SubmapFit>& tracked,
                                    const RecoveryParams& params,
                                    const SubmapRefinementParams& refinement) {
  const PreparedScan current = prepare(surfaces);
  const MatchParams match_params = params_of_a_known_place();
  const std::size_t num_tried = std::min(params.num_keyframes, keyframes.size());
  std::optional<RecoveredFit> best;
  double best_score = tracked ? tracked->alignment.score() + params.min_gain : 0.0;
  for (std::size_t k = 0; k < num_tried; ++k) {
    const Keyframe& keyframe = *keyframes[keyframes.size() - 1 - k];
    const MatchResult match = setsquare::match(prepare(keyframe.surfaces), current, match_params);
    if (!match.T_reference_current) continue;
    const Pose2 proposal = keyframe.T_odom_sensor * *match.T_reference_current;
    const TrackingProblem at_proposal{
        problem.submap, problem.points, proposal, problem.trust, problem.marks};
    const SubmapFit fit = refine_in_submap(at_proposal, proposal, refinement);
    const double score = fit.alignment.score();
    const bool is_far =
        !tracked || is_far_from(problem.T_odom_predicted, fit.T_odom_sensor, params);
    const bool is_certain = match.status == MatchStatus::kMatched && score >= params.far_min_score;
    if (score < best_score || (is_far && !is_certain)) continue;
    best = RecoveredFit{fit, is_far};
    best_score = score;
    if (score >= params.enough_score) break;
  }
  return best;
}

}  // namespace setsquare
