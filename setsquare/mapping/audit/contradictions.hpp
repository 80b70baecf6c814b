// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from audit, its only caller: the rules, tested without scans.
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <span>
#include <vector>

#include "setsquare/mapping/audit/pairs.hpp"

namespace setsquare {

/// A pair of keyframes that the guess-free matcher answered `matched`.
struct AuditMatch {
  AuditPair pair;
  Pose2 T_from_to;
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< As in MatchResult.
};

/// Where a match would have its later keyframe, against where the map has it.
struct AuditOffset {
  double off_m = 0.0;
  double off_rad = 0.0;  ///< Not negative.
  bool contradicts_map = false;
};

[[nodiscard]] AuditOffset audit_offset(const AuditMatch& match,
                                       const AuditedTrack& track,
                                       const AuditParams& params);

/// Whether it tells that the map is right, however much the map admits.
[[nodiscard]] bool agrees(const AuditOffset& offset, const AuditParams& params);

/// Matches that ask for the same correction of the same two parts of the track.
struct AlikeMatches {
  std::vector<std::size_t> members;  ///< Indices of the matches.
  std::size_t centre = 0;            ///< The match that most others are alike.
  std::size_t num_places = 0;        ///< Members that do not see the same from the same places.
};

/// These of the matches in groups, the greatest first; each is in one group, alone where nothing
/// seconds it.
[[nodiscard]] std::vector<AlikeMatches> alike_groups(std::span<const AuditMatch> matches,
                                                     std::vector<std::size_t> indices,
                                                     const AuditedTrack& track,
                                                     const AuditParams& params);

/// How the map would move about the later keyframe of a match, which stays what it is elsewhere.
[[nodiscard]] Pose2 correction_by(const AuditMatch& match, const AuditedTrack& track);

/// How many of these matches were not taken from the same places as one counted before.
[[nodiscard]] std::size_t num_places_of(std::span<const AuditMatch> matches,
                                        const std::vector<std::size_t>& indices,
                                        const AuditedTrack& track);

/// Contradictions that ask for the same correction: a hypothesis of how the map is wrong.
struct ContradictionGroup : AlikeMatches {
  std::size_t num_agreeing = 0;  ///< Independent matches between the same parts, with the map.
  bool raises_doubt = false;
  /// Behind an open stretch, and it asks for more than it extends over: two places that look alike
  /// may lie beside each other there. Told, but no reason to close the map by it.
  bool may_be_twin = false;

  /// Whether the map may be mended by it.
  [[nodiscard]] bool is_hypothesis() const { return raises_doubt && !may_be_twin; }
};

/// The matches that contradict the map in groups, the greatest first. A group raises a doubt if
/// enough places ask for its correction, by a majority over those between the same parts of the
/// track that agree with the map, and if tracking could have erred so.
[[nodiscard]] std::vector<ContradictionGroup> contradiction_groups(
    std::span<const AuditMatch> matches, const AuditedTrack& track, const AuditParams& params);

}  // namespace setsquare
