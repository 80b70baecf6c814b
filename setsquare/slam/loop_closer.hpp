// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/graph/pose_graph.hpp"
#include "setsquare/slam/closure_candidates.hpp"
#include "setsquare/slam/closure_verdict.hpp"
#include "setsquare/slam/keyframe_track.hpp"
#include "setsquare/slam/submap_matcher.hpp"

namespace setsquare {

/// Parameters of LoopCloser.
struct LoopCloserParams {
  std::size_t station_spacing = 3;    ///< Keyframes from station to station ...
  std::size_t submap_half_width = 3;  ///< ... and to either side of one in its submap.
  ClosureCandidateParams candidates;
  SubmapMatchParams match;
  ClosureVerdictParams verdict;
  /// How much a point tells: its own noise, and that of its neighbours, which is much the same.
  double point_sigma_m = 0.10;

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Two places that were compared, and what came of it. Poses are those of the sensors.
struct ComparedPlaces {
  std::size_t from = 0;  ///< Keyframe, the earlier one.
  std::size_t to = 0;    ///< Keyframe.
  Pose2 T_from_to;
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< As in Constraint.
  ClosureVerdict verdict;
  double score = 0.0;
  double contradiction = 0.0;
};

/// Finds where the track comes back to places it has seen.
///
/// 1. Every few keyframes along the track stand a station: a submap of the keyframes about it.
/// 2. Candidates: stations that may lie near each other, by position and its uncertainty.
/// 3. Each pair of submaps is matched at the fused headings, and judged.
/// Accepted closures shorten the way between places, and with it the windows of those that follow.
class LoopCloser {
 public:
  explicit LoopCloser(const LoopCloserParams& params = {});

  /// Looks at the stations that the track has gained. `T_map_sensor`: one a keyframe, as well as is
  /// known. Any number of threads gives the same closures.
  void extend(const KeyframeTrack& track,
              std::span<const Pose2> T_map_sensor,
              std::size_t num_threads);

  /// All pairs that were compared, in the order of their later station.
  [[nodiscard]] const std::vector<ComparedPlaces>& compared() const { return compared_; }

  /// Middle keyframes of the stations so far.
  [[nodiscard]] const std::vector<std::size_t>& stations() const { return stations_; }

 private:
  void add_stations(const KeyframeTrack& track);

  LoopCloserParams params_;
  ClosureCandidates candidates_;
  std::vector<std::size_t> stations_;
  std::vector<ComparedPlaces> compared_;
};

/// The constraint of a pair that was accepted.
[[nodiscard]] Constraint closure_constraint(const ComparedPlaces& places);

}  // namespace setsquare
