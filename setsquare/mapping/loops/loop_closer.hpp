// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/mapping/loops/candidates.hpp"
#include "setsquare/mapping/loops/verdict.hpp"
#include "setsquare/mapping/mapper_params.hpp"

namespace setsquare {

/// Finds where the track comes back to places it has seen.
///
/// 1. Every few keyframes along the track stand a station: a submap of the keyframes about it.
/// 2. Candidates: stations that may lie near each other, by position and its uncertainty.
/// 3. Each pair of submaps is matched at the fused headings, and judged.
/// Accepted closures shorten the way between places, and with it the windows of those that follow.
class LoopCloser {
 public:
  explicit LoopCloser(const LoopCloserParams& params = {});

  /// Places that are known to be the same, from elsewhere (join_pieces); accepted as they are.
  void add_joints(std::span<const ComparedPlaces> joints);

  /// Looks at the stations among the first `num_keyframes` of the track that it has not looked at.
  /// `T_map_sensor`: one per keyframe, as well as is known. Any number of threads gives the same
  /// closures.
  void extend(const KeyframeTrack& track,
              std::size_t num_keyframes,
              std::span<const Pose2> T_map_sensor,
              std::size_t num_threads);

  /// Of the keyframes only those of these indices, which ascend, are left, on the track as it is
  /// now: stations and compared places of others are forgotten.
  void keep_only(std::span<const std::size_t> kept, const KeyframeTrack& track);

  /// Keyframes, from the first on, whose stations it has looked at.
  [[nodiscard]] std::size_t num_looked_at() const {
    return stations_.empty() ? 0 : stations_.back();
  }

  /// All pairs that were compared: joints, then in the order of the later station.
  [[nodiscard]] const std::vector<ComparedPlaces>& compared() const { return compared_; }

 private:
  void add_stations(const KeyframeTrack& track, std::size_t num_keyframes);
  [[nodiscard]] std::vector<ComparedPlaces> compare(const KeyframeTrack& track,
                                                    std::span<const Pose2> T_map_sensor,
                                                    std::span<const ClosureCandidate> candidates,
                                                    std::size_t num_threads) const;
  [[nodiscard]] std::size_t nearest_station(std::size_t keyframe) const;

  LoopCloserParams params_;
  ClosureCandidates candidates_;
  std::vector<std::size_t> stations_;                                ///< Their middle keyframes.
  std::vector<std::pair<std::size_t, std::size_t>> joints_to_link_;  ///< Keyframes.
  std::vector<ComparedPlaces> compared_;
};

}  // namespace setsquare
