// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare::testing {

/// The exact scan of an empty room [0, width] x [0, depth] from a pose inside it, all around.
inline Scan scan_of_room(const Pose2& T_room_sensor,
                         double width_m,
                         double depth_m,
                         int num_beams) {
  Scan scan;
  scan.first_bearing_rad = -kPi;
  scan.bearing_step_rad = kTwoPi / num_beams;
  scan.max_range_m = 80.0;
  for (int beam = 0; beam < num_beams; ++beam) {
    const double direction_rad =
        T_room_sensor.theta_rad + scan.first_bearing_rad + beam * scan.bearing_step_rad;
    const double c = std::cos(direction_rad);
    const double s = std::sin(direction_rad);
    const double infinity = std::numeric_limits<double>::infinity();
    const double to_side_m =
        c == 0.0 ? infinity : ((c > 0.0 ? width_m : 0.0) - T_room_sensor.x_m) / c;
    const double to_end_m =
        s == 0.0 ? infinity : ((s > 0.0 ? depth_m : 0.0) - T_room_sensor.y_m) / s;
    scan.ranges_m.push_back(std::min(to_side_m, to_end_m));
  }
  return scan;
}

}  // namespace setsquare::testing
