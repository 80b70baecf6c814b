// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/core/loop_closure.hpp"
#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"
#include "setsquare/graph/pose_graph.hpp"
#include "setsquare/headings/fusion.hpp"
#include "setsquare/tracking/scan_tracker.hpp"

namespace setsquare {

/// A scan in the map.
struct MappedScan {
  Timestamp stamp;
  TrackStatus status = TrackStatus::kTracked;
  Pose2 T_map_sensor;
  Pose2 T_map_base;
  double score = 0.0;             ///< See TrackedPose; the paper's product of ZNCCs by PaperMapper.
  double effective_points = 0.0;  ///< See OpenDirection; 0 by PaperMapper.
  bool has_odometry = false;      ///< Whether odometry predicted it.
};

/// A pair of places that was compared, with the scans that it is about.
struct MappedClosure {
  LoopClosure closure;
  std::size_t scan_i = 0;
  std::size_t scan_j = 0;
};

/// A stretch of scans that tracking holds together.
struct TrackPiece {
  std::size_t first_scan = 0;
  std::size_t num_scans = 0;
  bool is_joined = true;  ///< With the largest piece; else nobody knows where it lies.
};

/// What a mapper knows at the end.
struct MappedTrack {
  std::vector<MappedScan> scans;        ///< Every scan, in the order in which it came.
  std::vector<std::size_t> keyframes;   ///< Indices of scans.
  FusedHeadings headings;               ///< One a keyframe; none by PaperMapper.
  std::vector<TrackPiece> pieces;       ///< One where tracking was never lost for long.
  std::vector<MappedClosure> closures;  ///< Accepted and refused; none by PaperMapper.
  /// Poses of `base` at the keyframes, the motion between them, the accepted closures with their
  /// weights, the headings measured; empty by PaperMapper.
  PoseGraph graph;
};

}  // namespace setsquare
