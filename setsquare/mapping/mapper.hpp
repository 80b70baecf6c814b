// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "setsquare/graph/robust_pose_graph.hpp"
#include "setsquare/headings/fusion.hpp"
#include "setsquare/headings/square_direction.hpp"
#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/mapping/loops/loop_closer.hpp"
#include "setsquare/mapping/mapped_track.hpp"
#include "setsquare/mapping/pieces/piece_joining.hpp"
#include "setsquare/mapping/registration.hpp"
#include "setsquare/scan/scan.hpp"
#include "setsquare/tracking/motion_uncertainty.hpp"
#include "setsquare/tracking/scan_tracker.hpp"

namespace setsquare {

/// Parameters of the mapper; every default works.
struct MapperParams {
  ScanTrackerParams tracker;
  SquareDirectionParams direction;
  MotionUncertaintyParams motion;
  HeadingFusionParams heading;
  LoopCloserParams closing;
  PieceJoiningParams joining;
  RobustPoseGraphParams robust;
  RegistrationParams registration;
  /// A direction's confidence grows with its margin over the next one: none at 1, full here.
  double confident_margin = 3.0;
  /// Loops are looked for each time the track has grown by this share, and by so many keyframes.
  double closing_growth = 0.1;
  std::size_t min_closing_growth = 64;
  std::size_t num_threads = 1;  ///< Any number gives the same map.

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Scans in, map out.
///
///   Mapper mapper;
///   for (const Scan& scan : log) mapper.add(scan);
///   const MappedTrack track = mapper.finish();
///
/// 1. Track: each scan is placed against the submap of recent keyframes (ScanTracker).
/// 2. Headings: each keyframe's walls measure its heading in the building, modulo a quarter turn;
///    fused with the tracked rotations they do not drift (fuse_headings).
/// 3. Loops: as the track grows, places near each other are compared, headings known (LoopCloser),
///    and positions solved, a linear problem (solve_positions).
/// 4. At the end: pieces of track between which tracking was lost are joined where they overlap
///    (join_pieces); weights of the closures by graduated non-convexity (solve_robustly), all
///    keyframes registered with their neighbours (register_keyframes), scans laid out between them
///    (assemble_track).
/// The map's axes are the building's. Memory grows with the log: a pose for every scan, and the
/// keyframes.
class Mapper {
 public:
  explicit Mapper(const MapperParams& params = {});

  /// The next scan of the log, with the robot's pose by wheel odometry where the log has one.
  /// Throws ParameterError where the scan's geometry is no scan's.
  TrackedPose add(const Scan& scan, const std::optional<Pose2>& T_wheels_base = std::nullopt);

  /// All poses so far; more scans may follow.
  [[nodiscard]] MappedTrack finish() const;

  [[nodiscard]] std::size_t num_scans() const { return scans_.size(); }

 private:
  /// What is kept of each scan.
  struct ScanEntry {
    Timestamp stamp;
    TrackedPose tracked;
    Pose2 T_base_sensor;
  };

  void add_keyframe(const Scan& scan);
  /// The track laid out along its headings, with the closures accepted so far.
  [[nodiscard]] PoseGraph graph_along(std::span<const double> headings_rad,
                                      const LoopCloser& closer) const;
  void close_loops(std::span<const double> headings_rad,
                   std::size_t num_keyframes,
                   LoopCloser& closer) const;
  /// Keyframes at which loops are looked for again.
  [[nodiscard]] std::size_t next_closing(std::size_t num_closed) const;
  /// Joins the pieces of the track, by quarter turns of the headings, and closes all loops anew.
  [[nodiscard]] LoopCloser close_across_pieces(FusedHeadings& headings, JoinedPieces& joined) const;
  void register_all(const LoopCloser& closer, PoseGraph& graph) const;
  [[nodiscard]] MappedTrack assemble(MappedTrack mapped,
                                     const LoopCloser& closer,
                                     const PoseGraph& graph,
                                     const JoinedPieces& joined) const;

  MapperParams params_;
  ScanTracker tracker_;
  MotionUncertainty uncertainty_;
  LoopCloser closer_;
  std::vector<ScanEntry> scans_;
  KeyframeTrack track_;
  std::vector<HeadingEvidence> evidence_;
  std::size_t num_closed_ = 0;  ///< Keyframes when loops were last looked for.
};

}  // namespace setsquare
