// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A map against itself, without closures.
#pragma once

#include <cstddef>
#include <span>

#include "setsquare/mapping/keyframe_track.hpp"

namespace setsquare {

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
