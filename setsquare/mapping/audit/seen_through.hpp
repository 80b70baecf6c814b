// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A map against itself, without closures.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "setsquare/mapping/keyframe_track.hpp"

namespace setsquare {

/// For each keyframe one of an earlier pass near by that saw through a good part of the walls it
/// shows, if there is one. One of each per keyframe: `surfaces`, `T_map_sensor`, and `way_m`,
/// travelled from the first. Any number of threads gives the same.
[[nodiscard]] std::vector<std::optional<std::size_t>> seen_through(
    std::span<const ScanSurfacesPtr> surfaces,
    std::span<const Pose2> T_map_sensor,
    std::span<const double> way_m,
    std::size_t num_threads);

/// Keyframes from `first` to `last` of which most are seen through, by keyframes from `first_by` to
/// `last_by`: two places lie over each other.
struct CrossedWalls {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t num = 0;  ///< Of those, seen through.
  std::size_t first_by = 0;
  std::size_t last_by = 0;
};

/// What is seen through along `min_crossed_m` of the way: a door that was opened, or people, are
/// seen through over a shorter way. `seen_through_by`: as seen_through() gives it.
[[nodiscard]] std::vector<CrossedWalls> crossed_walls(
    std::span<const std::optional<std::size_t>> seen_through_by,
    std::span<const double> way_m,
    double min_crossed_m);

/// Keyframes that a map contradicts: near by, on another pass, a scan saw through a good part of
/// the walls that they show. Where two places were taken for one, the corridor between them lies
/// in their rooms. `T_map_sensor`: one per keyframe. Any number of threads gives the same.
[[nodiscard]] std::size_t num_seen_through(const KeyframeTrack& track,
                                           std::span<const Pose2> T_map_sensor,
                                           std::size_t num_threads);

/// Whether either of two keyframes saw through a good part of the walls that the other one shows,
/// where `b` stands at `T_a_b` seen from `a`.
[[nodiscard]] bool see_through_each_other(const Keyframe& a, const Keyframe& b, const Pose2& T_a_b);

}  // namespace setsquare
