// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/mapping/mapper_params.hpp"

namespace setsquare {

/// Where a keyframe stands that adds nothing to the map: seen from an older one.
struct KnownPlace {
  std::size_t reference_scan = 0;  ///< Of the older keyframe, which shows something new.
  Pose2 T_reference_this;          ///< By the walls.
};

/// Finds keyframes that show nothing new: of a place that earlier visits cover, and whose walls
/// agree with what the last of these visits saw. A visit covers a keyframe with one of its own that
/// showed something new, stood near, looked the same way (any way where scans go all around), and
/// is of the same scanner; two visits are some way of driving apart, or of two sessions. Each
/// keyframe is examined once, against those that were examined before.
class KnownKeyframes {
 public:
  explicit KnownKeyframes(const ForgettingParams& params = {}) : params_(params) {}

  /// Examines those of the track's first `num_keyframes` that it has not. `T_map_sensor`: one per
  /// keyframe. Any number of threads gives the same.
  void examine(const KeyframeTrack& track,
               std::size_t num_keyframes,
               std::span<const Pose2> T_map_sensor,
               std::size_t num_threads);

  /// One per keyframe that was examined; nothing where it shows something new.
  [[nodiscard]] const std::vector<std::optional<KnownPlace>>& places() const { return places_; }

  /// Of the keyframes only those of these indices, which ascend, are left.
  void keep_only(std::span<const std::size_t> kept);
  /// So many scans before scan `end` are gone: those behind are numbered anew.
  void renumber(std::size_t end, std::size_t num_gone);

 private:
  ForgettingParams params_;
  std::vector<std::optional<KnownPlace>> places_;
};

/// The poses of keyframes, those of known ones by the walls of the keyframe that they were seen
/// from, which is one of the track. `T_map_sensor`: one per keyframe, by the loops.
[[nodiscard]] std::vector<Pose2> poses_of_known(const KeyframeTrack& track,
                                                std::span<const std::optional<KnownPlace>> places,
                                                std::span<const Pose2> T_map_sensor);

}  // namespace setsquare
