// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/graph/pose_graph.hpp"
#include "setsquare/tracking/keyframe.hpp"
#include "setsquare/tracking/motion_uncertainty.hpp"

namespace setsquare {
/// The keyframes of a log in their order, and the tracked motion between them.
struct KeyframeTrack {
  std::vector<KeyframePtr> keyframes;
  std::vector<MotionCovariance> motions;  ///< From the keyframe before; the first's is unused.
  /// Stretch of track, from 0: a new one begins where tracking was lost for so long that the submap
  /// restarted.
  std::vector<std::size_t> stretches;
  /// Piece of track, from 0: stretches that odometry ties to each other. Motion between pieces is
  /// unknown.
  std::vector<std::size_t> pieces;
  /// Keyframes at which a further session begins (MapSession): each begins a piece, and nothing at
  /// all is known of the motion to it. Empty where one log is mapped.
  std::vector<std::size_t> session_begins;
  /// The first keyframes, of the first session of a map that is gone on with: the largest piece of
  /// these is the one that the others are joined to. 0 where there is no such map: the largest of
  /// all.
  std::size_t num_known = 0;

  [[nodiscard]] std::size_t size() const { return keyframes.size(); }
  /// Scanners that keyframes come from, at least one: of so many keyframes each scanner has one,
  /// and they show the surroundings of one place.
  [[nodiscard]] std::size_t num_scanners() const;
};

/// The keyframe of a scan, which has one.
[[nodiscard]] std::size_t keyframe_of_scan(const KeyframeTrack& track, std::size_t scan_index);

/// Of each keyframe, how far the robot had driven when it was taken, in m, as tracked.
[[nodiscard]] std::vector<double> ways_m_of(const KeyframeTrack& track);

/// What each keyframe saw.
[[nodiscard]] std::vector<ScanSurfacesPtr> surfaces_of(const KeyframeTrack& track);

/// A scan that stands where it was seen from a keyframe.
struct HungScan {
  std::size_t scan_index = 0;
  std::size_t reference_scan = 0;  ///< The keyframe's.
  Pose2 T_reference_this;
};

/// The track as a pose graph with odometry constraints only. The tracked motion is laid out along
/// the headings: each displacement is turned by the drift half-way (heading less tracked heading).
/// Poses are those of the sensors; the first stands at the origin.
/// `headings_rad`: one per keyframe, in the map frame.
[[nodiscard]] PoseGraph pose_graph_of(const KeyframeTrack& track,
                                      std::span<const double> headings_rad);

/// A keyframe among the scans, with its pose in the map.
struct MappedKeyframe {
  std::size_t scan_index = 0;
  Pose2 T_map_sensor;
  bool begins_piece = false;  ///< Of track: the motion to it is unknown.
};

/// Poses of all scans from those of the keyframes: between two keyframes the tracked motion is laid
/// out from both, and the pose slides from the one to the other as the robot moves, by the squares
/// of its ways and turns, for at rest nothing drifts. Before the first, after the last and before
/// one that begins a piece of track, the nearest known keyframe alone gives the pose. `keyframes`
/// are in the order of the scans; without keyframes the tracked poses stay.
[[nodiscard]] std::vector<Pose2> assemble_track(std::span<const Pose2> T_odom_sensor,
                                                std::span<const MappedKeyframe> keyframes);

}  // namespace setsquare
