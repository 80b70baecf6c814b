// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/headings/doubted_turns.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/core/error.hpp"
#include "setsquare/core/sort_by.hpp"

namespace setsquare {
namespace {

/// How far the walls turned against the tracked rotation in a step, by the two keyframes alone; 0
/// unless both are sure of theirs.
double turn_of_walls_rad(const HeadingEvidence& before,
                         const HeadingEvidence& keyframe,
                         double period_rad,
                         const DoubtedTurnParams& params) {
  double least_rad = period_rad;
  for (const HeadingProposal& a : before.proposals) {
    if (a.confidence < params.min_sure * before.share_of_place) continue;
    for (const HeadingProposal& b : keyframe.proposals) {
      if (b.confidence < params.min_sure * keyframe.share_of_place) continue;
      const double turn_rad =
          b.heading_rad - keyframe.tracked_heading_rad - a.heading_rad + before.tracked_heading_rad;
      least_rad = std::min(least_rad, std::abs(wrap_to_period(turn_rad, period_rad)));
    }
  }
  return least_rad < period_rad ? least_rad : 0.0;
}

/// Steps whose keyframes are both sure of walls that turned too far from the one to the other.
std::vector<DoubtedTurn> turns_in_one_step(const std::vector<HeadingEvidence>& keyframes,
                                           double period_rad,
                                           const DoubtedTurnParams& params) {
  std::vector<DoubtedTurn> turns;
  for (std::size_t k = 1; k < keyframes.size(); ++k) {
    const double turn_rad = turn_of_walls_rad(keyframes[k - 1], keyframes[k], period_rad, params);
    if (turn_rad > params.min_sure_rad) turns.push_back({.from = k - 1, .to = k});
  }
  return turns;
}

/// Steps, by the keyframe that each leads to, within which the walls turned too far.
std::vector<bool> doubted_steps(const std::vector<HeadingEvidence>& keyframes,
                                const HeadingTrace& trace,
                                const std::vector<double>& drift_rad,
                                const DoubtedTurnParams& params) {
  const std::size_t n = keyframes.size();
  std::vector<double> variance_rad2(n, 0.0);  // From the first keyframe on.
  for (std::size_t k = 1; k < n; ++k) {
    const double sigma_rad = keyframes[k].step_sigma_rad;
    variance_rad2[k] = variance_rad2[k - 1] + sigma_rad * sigma_rad;
  }
  std::vector<bool> is_doubted(n, false);
  for (std::size_t k = 1; k < n; ++k) {
    const std::size_t before = k < params.num_steps ? 0 : k - params.num_steps;
    const double sigma_rad = std::sqrt(variance_rad2[k] - variance_rad2[before]);
    const double allowed_rad = std::max(params.min_rad, params.min_sigmas * sigma_rad);
    const bool has_turned = std::abs(drift_rad[k] - drift_rad[before]) > allowed_rad;
    for (std::size_t i = before + 1; has_turned && i <= k; ++i) {
      const bool moves = std::abs(drift_rad[i] - drift_rad[i - 1]) > 0.0;
      if (moves) is_doubted[i] = true;
    }
    if (trace.is_change[k]) is_doubted[k] = true;
  }
  return is_doubted;
}

/// Whether the keyframe shows the walls that the trace follows.
bool shows_walls(const HeadingEvidence& keyframe,
                 double offset_rad,
                 const HeadingTraceParams& trace_params,
                 const DoubtedTurnParams& params) {
  for (const HeadingProposal& proposal : keyframe.proposals) {
    const double miss_rad = wrap_to_period(
        proposal.heading_rad - keyframe.tracked_heading_rad - offset_rad, trace_params.period_rad);
    if (std::abs(miss_rad) < trace_params.inlier_rad &&
        proposal.confidence >= params.min_belief * keyframe.share_of_place) {
      return true;
    }
  }
  return false;
}

bool is_confirmed(const std::vector<HeadingEvidence>& keyframes, const DoubtedTurn& turn) {
  for (std::size_t k = turn.from + 1; k <= turn.to; ++k) {
    if (!keyframes[k].is_step_confirmed) return false;
  }
  return true;
}

}  // namespace

void DoubtedTurnParams::validate() const {
  if (num_steps < 1) throw ParameterError("num_steps", "must be at least 1");
  if (!(min_rad > 0.0)) throw ParameterError("min_rad", "must be positive");
  if (!(min_sigmas > 0.0)) throw ParameterError("min_sigmas", "must be positive");
  if (!(min_sure > 0.0)) throw ParameterError("min_sure", "must be positive");
  if (!(min_sure_rad > 0.0)) throw ParameterError("min_sure_rad", "must be positive");
  if (!(min_belief > 0.0)) throw ParameterError("min_belief", "must be positive");
}

std::vector<DoubtedTurn> doubted_turns(const std::vector<HeadingEvidence>& keyframes,
                                       const HeadingTrace& trace,
                                       const std::vector<double>& drift_rad,
                                       const HeadingTraceParams& trace_params,
                                       const DoubtedTurnParams& params) {
  const std::vector<bool> is_doubted = doubted_steps(keyframes, trace, drift_rad, params);
  std::vector<DoubtedTurn> turns = turns_in_one_step(keyframes, trace_params.period_rad, params);
  const std::size_t num_steps = turns.size();
  for (std::size_t k = 1; k < keyframes.size(); ++k) {
    if (!is_doubted[k]) continue;
    DoubtedTurn turn{.from = k - 1, .to = k};
    for (std::size_t i = 0; i < params.max_margin && turn.from > 0; ++i, --turn.from) {
      if (shows_walls(keyframes[turn.from], trace.offset_rad[k - 1], trace_params, params)) break;
    }
    for (std::size_t i = 0; i < params.max_margin && turn.to + 1 < keyframes.size();
         ++i, ++turn.to) {
      if (shows_walls(keyframes[turn.to], trace.offset_rad[k], trace_params, params)) break;
    }
    if (turns.size() > num_steps && turn.from < turns.back().to) {
      turns.back().to = std::max(turns.back().to, turn.to);
    } else {
      turns.push_back(turn);
    }
  }
  std::erase_if(turns, [&](const DoubtedTurn& turn) { return is_confirmed(keyframes, turn); });
  for (DoubtedTurn& turn : turns) {
    turn.turned_rad = trace.offset_rad[turn.to] - trace.offset_rad[turn.from];
  }
  return turns;
}

std::vector<DoubtedTurn> without_settled(std::vector<DoubtedTurn> turns,
                                         std::span<const TurnedWalls> turned) {
  std::erase_if(turns, [&](const DoubtedTurn& turn) {
    return std::ranges::any_of(turned, [&](const TurnedWalls& walls) {
      return (turn.from < walls.first && walls.first <= turn.to) ||
             (turn.from < walls.end && walls.end <= turn.to);
    });
  });
  return turns;
}

std::vector<DoubtedTurn> distinct_turns(std::vector<DoubtedTurn> turns) {
  sort_by(turns, &DoubtedTurn::from);
  std::vector<DoubtedTurn> distinct;
  for (const DoubtedTurn& turn : turns) {
    if (distinct.empty() || turn.from >= distinct.back().to) {
      distinct.push_back(turn);
      continue;
    }
    DoubtedTurn& same = distinct.back();
    same.to = std::max(same.to, turn.to);
    if (std::abs(turn.turned_rad) > std::abs(same.turned_rad)) same.turned_rad = turn.turned_rad;
  }
  return distinct;
}

}  // namespace setsquare
