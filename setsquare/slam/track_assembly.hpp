// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// A keyframe among the scans, with its pose in the map.
struct MappedKeyframe {
  std::size_t scan_index = 0;
  Pose2 T_map_sensor;
  bool begins_piece = false;  ///< Of track: how the robot came there is not known.
};

/// Poses of all scans from those of the keyframes: between two keyframes the tracked motion is laid
/// out from both, and the pose slides from the one to the other with the scans; before the first,
/// after the last and before one that begins a piece of track it hangs on the nearest one that is
/// known. `keyframes` are in the order of the scans; where there
/// are none the tracked poses stay.
[[nodiscard]] std::vector<Pose2> assemble_track(std::span<const Pose2> T_odom_sensor,
                                                std::span<const MappedKeyframe> keyframes);

}  // namespace setsquare
