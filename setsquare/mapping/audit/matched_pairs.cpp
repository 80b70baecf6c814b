// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/audit/matched_pairs.hpp"

#include <algorithm>

#include "setsquare/core/parallel.hpp"
#include "setsquare/matching/scan_matcher.hpp"

namespace setsquare {

std::vector<AuditedPlace> MatchedPairs::places(const std::vector<std::size_t>& keyframes) {
  prepare_all(keyframes);
  std::vector<AuditedPlace> places(keyframes.size());
  run_in_parallel(keyframes.size(), num_threads_, [&](std::size_t i) {
    const std::size_t k = keyframes[i];
    places[i] = {k, place_signature(prepared_[k]->fine, track_.T_map_sensor[k].theta_rad)};
  });
  return places;
}

void MatchedPairs::match(const std::vector<AuditPair>& pairs, MatchEffort effort) {
  std::vector<AuditPair> untried;
  std::vector<std::size_t> needed;
  for (const AuditPair& pair : pairs) {
    if (!tried_.insert(pair).second) continue;
    untried.push_back(pair);
    needed.push_back(pair.from);
    needed.push_back(pair.to);
  }
  prepare_all(needed);
  MatchParams params;
  if (effort == MatchEffort::kQuick) params.thorough.num_rotations = 0;
  std::vector<MatchResult> results(untried.size());
  run_in_parallel(untried.size(), num_threads_, [&](std::size_t i) {
    results[i] = setsquare::match(*prepared_[untried[i].from], *prepared_[untried[i].to], params);
  });
  for (std::size_t i = 0; i < untried.size(); ++i) {
    if (results[i].status != MatchStatus::kMatched) continue;
    matches_.push_back({untried[i], *results[i].T_reference_current, results[i].information});
  }
}

void MatchedPairs::prepare_all(std::vector<std::size_t> keyframes) {
  std::sort(keyframes.begin(), keyframes.end());
  keyframes.erase(std::unique(keyframes.begin(), keyframes.end()), keyframes.end());
  std::erase_if(keyframes, [&](std::size_t k) { return prepared_[k].has_value(); });
  run_in_parallel(keyframes.size(), num_threads_, [&](std::size_t i) {
    const std::size_t k = keyframes[i];
    prepared_[k] = prepare(surfaces_[track_.keyframes[k]]);
  });
}

}  // namespace setsquare
