// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/rooms.hpp"

namespace setsquare::testing {

/// The exact scan of an empty room [0, width] x [0, depth] from a pose inside it, all around.
inline Scan scan_of_room(const Pose2& T_room_sensor,
                         double width_m,
                         double depth_m,
                         std::size_t num_beams) {
  const Fan all_around = {num_beams, -kPi, kTwoPi / static_cast<double>(num_beams)};
  return scan_of_walls(empty_rectangle(width_m, depth_m), T_room_sensor, all_around);
}

}  // namespace setsquare::testing
