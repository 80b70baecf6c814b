// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Shared by audit, which compares matches with the map, and closures_anywhere, which closes loops
// by them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "setsquare/mapping/audit/contradictions.hpp"
#include "setsquare/mapping/audit/pairs.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {

/// How hard a match is sought: by rotations from the walls' directions alone, which finds nine in
/// ten and costs an eighth; or over every rotation of the circle where these find nothing.
enum class MatchEffort { kQuick, kThorough };

/// Pairs of a track's scans matched as if nothing were known of them: the scans prepared when they
/// are first needed, and what matched so far. Any number of threads gives the same matches.
class MatchedPairs {
 public:
  /// `surfaces`: one per keyframe of the map. Both must outlive it.
  MatchedPairs(const AuditedTrack& track,
               std::span<const ScanSurfacesPtr> surfaces,
               std::size_t num_threads)
      : track_(track), surfaces_(surfaces), num_threads_(num_threads), prepared_(track.size()) {}

  /// What these keyframes of the track look like.
  [[nodiscard]] std::vector<AuditedPlace> places(const std::vector<std::size_t>& keyframes);

  /// Matches those of the pairs that it has not matched.
  void match(const std::vector<AuditPair>& pairs, MatchEffort effort);

  /// Matches pairs about the first of some groups of matches, at most `max_num` of them,
  /// thoroughly: what the pair in each group's middle tells is asked of others. `groups`: with
  /// `centre`, an index of matches().
  template <typename Group>
  void match_about(const std::vector<Group>& groups, std::size_t max_num) {
    std::vector<AuditPair> pairs;
    for (std::size_t i = 0; i < std::min(groups.size(), max_num); ++i) {
      const auto about = pairs_about(track_, matches_[groups[i].centre].pair);
      pairs.insert(pairs.end(), about.begin(), about.end());
    }
    match(pairs, MatchEffort::kThorough);
  }

  [[nodiscard]] std::size_t num_tried() const { return tried_.size(); }
  /// Those that were answered MatchStatus::kMatched.
  [[nodiscard]] const std::vector<AuditMatch>& matches() const { return matches_; }

 private:
  void prepare_all(std::vector<std::size_t> keyframes);

  const AuditedTrack& track_;
  std::span<const ScanSurfacesPtr> surfaces_;
  std::size_t num_threads_;
  std::vector<std::optional<PreparedScan>> prepared_;  ///< One per keyframe of the track.
  std::set<AuditPair> tried_;
  std::vector<AuditMatch> matches_;
};

}  // namespace setsquare
