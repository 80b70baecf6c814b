// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from audit, its only caller: which pairs are worth a match, tested without scans.
#pragma once

#include <compare>
#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/mapping/pieces/place_signature.hpp"

namespace setsquare {

/// Two of a track's keyframes, the earlier first.
struct AuditPair {
  std::size_t from = 0;
  std::size_t to = 0;

  auto operator<=>(const AuditPair&) const = default;
};

/// A map's keyframes that are placed and not lost, in their order.
struct AuditedTrack {
  std::vector<std::size_t> keyframes;  ///< Indices of Map::keyframes.
  std::vector<Pose2> T_map_sensor;
  std::vector<double> way_m;          ///< Travelled from the first to each, by the map.
  std::vector<double> open_m2;        ///< Variance of that which the map admits.
  std::vector<bool> is_open;          ///< Whether the walls left a direction open there.
  std::vector<AuditPair> breaks;      ///< Neither side is in a stretch that tracking did not hold.
  std::vector<std::size_t> losses;    ///< Keyframes before which tracking had lost a scan.
  std::vector<std::size_t> restarts;  ///< Keyframes at which tracking began anew: any turn is open.
  std::vector<AuditPair> outvoted;    ///< Ends of accepted closures that all others outvoted.
  /// Keyframes to which a long step leads, one of many: tracking had it from a few matches.
  std::vector<std::size_t> long_steps;

  [[nodiscard]] std::size_t size() const { return keyframes.size(); }
};

[[nodiscard]] AuditedTrack audited_track(const Map& map);

/// A place of the track by what it looks like.
struct AuditedPlace {
  std::size_t keyframe = 0;  ///< Of the track.
  PlaceSignature signature;
};

/// Places of the track at even intervals, at most `max_num`.
[[nodiscard]] std::vector<std::size_t> spread_places(const AuditedTrack& track,
                                                     std::size_t max_num);

/// The sample that is matched first, each pair once and in order: across the breaks, at both ends
/// of outvoted closures, near by the map, alike by signature. The same track gives the same pairs.
[[nodiscard]] std::vector<AuditPair> sampled_pairs(const AuditedTrack& track,
                                                   std::span<const AuditedPlace> places,
                                                   const AuditParams& params);

/// Places that tell where they are, at even intervals over them, at most `max_num`: none where the
/// walls leave a direction open.
[[nodiscard]] std::vector<std::size_t> telling_places(const AuditedTrack& track,
                                                      std::size_t max_num);

/// Pairs of places that may be one, for all that is known of the way between them: behind open
/// stretches, as far apart as these may be off, the `num_alike` that look most alike for each
/// place.
[[nodiscard]] std::vector<AuditPair> pairs_within_spread(const AuditedTrack& track,
                                                         std::span<const AuditedPlace> places,
                                                         const AuditParams& params,
                                                         std::size_t num_alike);

/// Pairs about one that contradicts the map: what they say seconds it, or does not.
[[nodiscard]] std::vector<AuditPair> pairs_about(const AuditedTrack& track, const AuditPair& pair);

}  // namespace setsquare
