// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// From the sensor's poses, in which the mapper works, to the robot's, which a map holds.
#pragma once

#include <span>
#include <vector>

#include "setsquare/graph/pose_graph.hpp"
#include "setsquare/headings/fusion.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/mapping/loops/verdict.hpp"
#include "setsquare/mapping/tracked_scans.hpp"

namespace setsquare {

/// All that a map is made of; everything must outlive the call. Poses are those of the sensors.
struct MapParts {
  const TrackedScans& scans;
  std::size_t num_scans = 0;  ///< The first ones, of which the map is made.
  std::span<const KeptScan> kept_scans;
  const KeyframeTrack& track;
  std::span<const double> shares_of_place = {};  ///< One per keyframe.
  /// In their order: scans of keyframes that were forgotten.
  std::span<const HungScan> hung_scans = {};
  std::span<const MapSession> sessions = {};  ///< One of all scans where there are none.
  std::span<const ForgottenPoses> gaps = {};  ///< Map::forgotten_poses.
  FusedHeadings headings = {};
  std::span<const ComparedPlaces> compared = {};
  std::vector<bool> is_joined = {};  ///< One per piece of the track.
  /// A node per keyframe. The source of an accepted closure's constraint is its index in
  /// `compared`.
  PoseGraph graph = {};
};

/// The map, but for what is certain of it (add_certainty).
[[nodiscard]] Map assemble_map(const MapParts& parts);

/// What was compared, with the final weights of what was accepted: those of the graph's
/// constraints, whose source is the index in `compared`.
[[nodiscard]] std::vector<MappedClosure> mapped_closures(const KeyframeTrack& track,
                                                         std::span<const ComparedPlaces> compared,
                                                         const PoseGraph& graph);

/// The pieces of the track as ranges of scans: each begins with its first keyframe, the first one
/// of a session with the session.
[[nodiscard]] std::vector<TrackPiece> pieces_of(const KeyframeTrack& track,
                                                const std::vector<bool>& is_joined,
                                                std::size_t num_scans,
                                                std::span<const MapSession> sessions = {});

/// The same graph of the poses of `base`.
[[nodiscard]] PoseGraph graph_of_base(const KeyframeTrack& track, const PoseGraph& graph);

}  // namespace setsquare
