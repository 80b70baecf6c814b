// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "setsquare/graph/heading_fusion.hpp"
#include "setsquare/matching/square_direction.hpp"
#include "setsquare/scan/scan.hpp"
#include "setsquare/slam/mapped_track.hpp"
#include "setsquare/slam/scan_tracker.hpp"

namespace setsquare {

/// How certain a tracked rotation between neighbouring keyframes is.
struct TrackedRotationParams {
  double step_sigma_rad = rad_from_deg(0.08);  ///< Of every step ...
  double sigma_per_turn = 0.01;                ///< ... and this share of the turn.
  double lost_sigma_rad = 0.05;                ///< Of each lost scan in between.
  double recovered_sigma_rad = 0.2;            ///< Of each scan found again far off.
  double restart_sigma_rad = 0.5;              ///< Of each new start of the submap.
};

/// Parameters of the mapper; every default works.
struct MapperParams {
  ScanTrackerParams tracker;
  SquareDirectionParams direction;
  TrackedRotationParams rotation;
  HeadingFusionParams heading;
  /// A direction's confidence grows with its margin over the next one: none at 1, full here.
  double confident_margin = 3.0;

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Scans in, poses out: sequential, no loop closing.
///
///   Mapper mapper;
///   for (const Scan& scan : log) mapper.add(scan);
///   const MappedTrack track = mapper.finish();
///
/// 1. Each scan is tracked against the submap of recent keyframes (ScanTracker).
/// 2. Each keyframe's walls measure its heading in the building, modulo a quarter turn: its highest
///    peak of direction is its one proposal, believed by its margin over the next; without a margin
///    there is none.
/// 3. At the end headings are fused (fuse_headings) and the tracked motion is laid out again along
///    them (assemble_track). The map's axes are the building's.
/// Memory grows with the number of scans by their poses only.
class Mapper {
 public:
  explicit Mapper(const MapperParams& params = {});

  /// The next scan of the log, with the robot's pose by wheel odometry where the log has one.
  /// Throws ParameterError where the scan's geometry is no scan's.
  TrackedPose add(const Scan& scan, const std::optional<Pose2>& T_wheels_base = std::nullopt);

  /// All poses so far; more scans may follow.
  [[nodiscard]] MappedTrack finish() const;

  [[nodiscard]] std::size_t num_scans() const { return tracked_.size(); }

 private:
  /// What is kept of each scan.
  struct Entry {
    Timestamp stamp;
    TrackedPose tracked;
    Pose2 T_base_sensor;
  };

  void measure_heading(const Scan& scan, const TrackedPose& tracked);

  MapperParams params_;
  ScanTracker tracker_;
  std::vector<Entry> tracked_;
  std::vector<std::size_t> keyframes_;
  std::vector<HeadingEvidence> evidence_;
  double step_variance_rad2_ = 0.0;  ///< Of what was lost or found again since the last keyframe.
};

}  // namespace setsquare
