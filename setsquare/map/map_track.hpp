// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What tracking found, of which a map was made: with it a mapper goes on where another one ended.
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/map/motion_covariance.hpp"

namespace setsquare {

/// How the track came to a keyframe.
struct TrackedMotion {
  Pose2 T_odom_body;            ///< Of the robot at the keyframe, as tracking followed it.
  MotionCovariance covariance;  ///< Of the motion from the keyframe before.
  /// Stretch of track, from 0: a new one begins where tracking was lost for so long that it began
  /// anew. Those that odometry ties to each other are one piece (TrackPiece).
  std::size_t stretch = 0;
  double share_of_place = 1.0;  ///< As one of the scanners that leave keyframes of a place.
};

/// The track as it was before any loop was closed. Of what else a mapper needs, scans, keyframes,
/// pieces, the map itself tells. Empty by PaperMapper.
struct MapTrack {
  /// One per scan, in the odom frame of its session: tracking begins each at the identity.
  std::vector<Pose2> T_odom_sensor;
  std::vector<TrackedMotion> motions;  ///< One per keyframe.
};

/// How it went when a session was looked for in the map.
struct SessionSearch {
  std::size_t num_pairs = 0;     ///< Pairs of places that were compared, ...
  std::size_t num_matched = 0;   ///< ... those that matched and stood alone, ...
  std::size_t num_agreeing = 0;  ///< ... and places that agreed, at most, on where it lies.
};

/// The scans of one log, in their order: a map that was continued or merged has several. Nothing is
/// known of the way from one to the next.
struct MapSession {
  std::size_t first_scan = 0;  ///< Of Map::scans.
  std::size_t num_scans = 0;   ///< From there on.
  /// Sessions of a higher one are newer: where walls changed, the grid shows what the newest saw.
  std::size_t recency = 0;
  SessionSearch search;  ///< Zeros of the first one, by which the others are placed.
};

}  // namespace setsquare
