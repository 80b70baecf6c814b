// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/told_turns.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/median.hpp"
#include "setsquare/core/sort_by.hpp"

namespace setsquare {
namespace {

/// How far hypotheses have the robot turned across a turn beyond what the headings say, of those
/// that the turn explains.
std::vector<double> explained_rad(const DoubtedTurn& turn,
                                  const FusedHeadings& headings,
                                  std::span<const MapHypothesis> hypotheses,
                                  double agreeing_rad) {
  std::vector<double> explained;
  for (const MapHypothesis& told : hypotheses) {
    const auto [first, last] = std::minmax(told.keyframe_from, told.keyframe_to);
    if (first > turn.from || last < turn.to) continue;
    const double turned_rad =
        headings.heading_rad[told.keyframe_to] - headings.heading_rad[told.keyframe_from];
    const double beyond_rad = wrap_to_pi(told.T_from_to.theta_rad - turned_rad);
    const double unlike_rad = std::abs(beyond_rad) - std::abs(turn.turned_rad);
    if (std::abs(unlike_rad) > agreeing_rad) continue;
    explained.push_back(told.keyframe_from < told.keyframe_to ? beyond_rad : -beyond_rad);
  }
  return explained;
}

}  // namespace

std::vector<ToldTurn> told_turns(const FusedHeadings& headings,
                                 std::span<const MapHypothesis> hypotheses,
                                 const TurnCheckParams& params) {
  constexpr std::size_t kMostTold = 3;
  std::vector<std::pair<std::size_t, ToldTurn>> by_number;
  for (const DoubtedTurn& turn : headings.doubted) {
    std::vector<double> beyond_rad = explained_rad(turn, headings, hypotheses, params.agreeing_rad);
    if (beyond_rad.empty()) continue;
    const std::size_t number = beyond_rad.size();
    const double fused_rad = headings.drift_rad[turn.to] - headings.drift_rad[turn.from];
    by_number.push_back({number, {turn, wrap_to_pi(fused_rad + median(std::move(beyond_rad)))}});
  }
  sort_by_greatest(by_number, [](const auto& entry) { return entry.first; });
  std::vector<ToldTurn> told;
  for (const auto& [number, turn] : by_number) {
    if (told.size() < kMostTold) told.push_back(turn);
  }
  return told;
}

}  // namespace setsquare
