// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/mapping/audit/contradictions.hpp"
#include "setsquare/mapping/audit/seen_through.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {

/// A way in which a map may be wrong: two of its keyframes, and where scans have the one in the
/// other. The mapper closes its loops again by them, where that explains more of all matches.
struct MapHypothesis {
  std::size_t keyframe_from = 0;  ///< Of Map::keyframes.
  std::size_t keyframe_to = 0;
  Pose2 T_from_to;                                        ///< Of the sensors.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< As in Constraint.
  std::size_t num_places = 0;                             ///< Independent matches that ask for it.
  std::size_t num_agreeing = 0;                           ///< Such that agree with the map instead.
};

/// That of a match.
[[nodiscard]] MapHypothesis hypothesis_by(const AuditMatch& match,
                                          const AuditedTrack& track,
                                          std::size_t num_places,
                                          std::size_t num_agreeing = 0);

/// What an audit found.
struct AuditFindings {
  AuditReport report;
  AuditedTrack track;
  std::vector<AuditMatch> matches;
  std::vector<ContradictionGroup> groups;  ///< Of the matches; the greatest first.
  std::vector<CrossedWalls> crossed;       ///< Of the track's keyframes.
  std::vector<std::size_t> unseconded;     ///< Of the map's keyframes: unseconded_steps().
  std::vector<std::size_t> astray;         ///< Likewise: astray_keyframes().

  /// One for each match of the groups that raise a doubt, but for those that may be of twins.
  [[nodiscard]] std::vector<MapHypothesis> hypotheses() const;
};

/// Matches pairs of a map's keyframes without a guess and compares the answers with the map.
///
/// 1. Sample: pairs near each other by the map, alike by signature, across breaks of tracking, at
///    both ends of outvoted closures (sampled_pairs).
/// 2. Match each as if nothing were known of the two scans.
/// 3. Where a match contradicts the map, match more pairs about it.
/// 4. Group what contradicts alike, and weigh it against what agrees (contradiction_groups).
/// 5. Where passes lie over each other, look through the walls of each (crossed_walls): two places
///    that the map took for one need not match anywhere.
/// 6. Second each long step of a log of key frames (unseconded_steps), and each place between two
///    (astray_keyframes).
/// `surfaces`: one per keyframe of the map. Any number of threads gives the same findings. Throws
/// ParameterError.
[[nodiscard]] AuditFindings audit(const Map& map,
                                  std::span<const ScanSurfacesPtr> surfaces,
                                  const AuditParams& params,
                                  std::size_t num_threads);

/// Writes them into the map: Map::audit and Map::doubts.
void add_findings(const AuditFindings& findings, const AuditParams& params, Map& map);

/// Whether a map explains more of all matches than another: a larger share agrees with it, and
/// fewer contradict it alike.
[[nodiscard]] bool explains_more(const AuditReport& mended, const AuditReport& before);

/// Whether a map explains at least as much of all matches as another.
[[nodiscard]] bool explains_as_much(const AuditReport& mended, const AuditReport& before);

/// Both: audit() and add_findings().
void audit_map(Map& map,
               std::span<const ScanSurfacesPtr> surfaces,
               const AuditParams& params,
               std::size_t num_threads);

}  // namespace setsquare
