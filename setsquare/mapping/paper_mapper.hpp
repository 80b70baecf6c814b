// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "setsquare/map/map.hpp"
#include "setsquare/mapping/kept_scans.hpp"
#include "setsquare/paper/paper_matcher.hpp"
#include "setsquare/scan/scan.hpp"
#include "setsquare/tracking/tracked_pose.hpp"

namespace setsquare {

/// Parameters of PaperMapper.
struct PaperMapperParams {
  /// In a sequence neighbours turn by far less than a quarter turn: of the four offsets the nearest
  /// is taken. Our reading of section 5.2; the paper does not say. On its own the paper's choice
  /// takes a wrong quarter or half turn every few hundred scans.
  PaperParams matcher = {.max_rotation_rad = rad_from_deg(45.0)};
  double keyframe_distance_m = 0.4;  ///< Section 5.1.
  double keyframe_turn_rad = rad_from_deg(10.0);
  /// After this many rejected scans in a row the last one restarts the map at the last known place
  /// of the robot, with the heading that its walls measure, in the nearest quarter turn.
  std::size_t max_rejected = 10;
  /// Scans with fewer thinned points are lost: not matched, not kept, not counted as rejected.
  std::size_t min_points = 10;

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// The paper's map building (bando2014, section 5.2): scan to scan, by its own method alone, each
/// scan against the previous keyframe, poses chained; no odometry, no fusion, no submap. The paper
/// does not say what it does with a rejected match, nor with a scan that sees next to nothing: here
/// the robot is taken to stand still. Nor does it say how neighbouring scans chose among the four
/// offsets: see PaperMapperParams::matcher.
class PaperMapper {
 public:
  explicit PaperMapper(const PaperMapperParams& params = {});

  /// The next scan of the log. Throws ParameterError where the scan's geometry is invalid.
  TrackedPose add(const Scan& scan);
  /// The same with the scan prepared beforehand, by the mapper's own parameters.
  TrackedPose add(const Scan& scan, PreparedPaperScan prepared);

  /// All poses so far. The map's frame is the first keyframe's, turned by its dominant direction.
  [[nodiscard]] Map finish() const;

 private:
  TrackedPose place(const PreparedPaperScan& current);
  void follow(const MatchResult& match, const PreparedPaperScan& current, TrackedPose& tracked);
  [[nodiscard]] double measured_heading_rad(const PreparedPaperScan& current) const;

  PaperMapperParams params_;
  std::optional<PreparedPaperScan> keyframe_;
  Pose2 T_map_keyframe_;
  Pose2 T_map_sensor_;
  std::size_t num_rejected_ = 0;  ///< In a row.
  Map map_;
  KeptScanChoice kept_;
};

}  // namespace setsquare
