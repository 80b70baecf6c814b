// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/audit/unseconded_steps.hpp"

#include <algorithm>

namespace setsquare {
namespace {

/// The pairs of scans so many steps apart that span a step.
std::vector<AuditPair> pairs_across(const std::vector<std::size_t>& steps,
                                    std::size_t num_steps,
                                    const AuditedTrack& track) {
  std::vector<AuditPair> pairs;
  for (const std::size_t step : steps) {
    for (std::size_t behind = 0; behind < num_steps; ++behind) {
      const std::size_t to = step + behind;
      if (to < num_steps || to >= track.size()) continue;
      pairs.push_back({to - num_steps, to});
    }
  }
  return pairs;
}

}  // namespace

std::vector<std::size_t> without_second(const std::vector<std::size_t>& steps,
                                        std::span<const AuditMatch> matches,
                                        const AuditedTrack& track,
                                        const AuditParams& params) {
  std::vector<int> majority(track.size(), 0);  // Of the matches that agree.
  for (const AuditMatch& match : matches) {
    if (match.pair.to - match.pair.from > kMaxSecondingSteps) continue;
    const int vote = agrees(audit_offset(match, track, params), params) ? 1 : -1;
    for (std::size_t k = match.pair.from + 1; k <= match.pair.to; ++k) majority[k] += vote;
  }
  std::vector<std::size_t> left = steps;
  std::erase_if(left, [&](std::size_t step) { return majority[step] > 0; });
  return left;
}

std::vector<std::size_t> astray_keyframes(std::span<const AuditMatch> matches,
                                          const AuditedTrack& track,
                                          const AuditParams& params) {
  std::vector<int> for_place(track.size(), 0);  // Of the matches that end there.
  std::vector<int> over_place(track.size(), 0);
  for (const AuditMatch& match : matches) {
    const auto [from, to] = match.pair;
    if (to - from > kMaxSecondingSteps) continue;
    const int vote = agrees(audit_offset(match, track, params), params) ? 1 : -1;
    for_place[from] += vote;
    for_place[to] += vote;
    for (std::size_t k = from + 1; k < to; ++k) over_place[k] += vote;
  }
  std::vector<std::size_t> astray;
  for (const std::size_t step : track.long_steps) {
    if (for_place[step] <= 0 && over_place[step] > 0) astray.push_back(step);
  }
  return astray;
}

std::vector<std::size_t> unseconded_steps(const AuditedTrack& track,
                                          const AuditParams& params,
                                          MatchedPairs& matched) {
  for (const std::size_t num_steps : {std::size_t{1}, std::size_t{2}}) {
    matched.match(pairs_across(track.long_steps, num_steps, track), MatchEffort::kQuick);
  }
  const auto left = [&] {
    return without_second(track.long_steps, matched.matches(), track, params);
  };
  matched.match(pairs_across(left(), kMaxSecondingSteps, track), MatchEffort::kQuick);
  return left();
}

}  // namespace setsquare
