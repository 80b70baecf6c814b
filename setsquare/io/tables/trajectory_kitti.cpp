// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/tables/trajectory_kitti.hpp"

#include <fmt/core.h>

#include <cmath>
#include <iterator>

namespace setsquare {

std::string kitti_from_trajectory(const Trajectory& trajectory) {
  std::string text;
  for (const StampedPose& stamped : trajectory) {
    const double c = std::cos(stamped.pose.theta_rad);
    const double s = std::sin(stamped.pose.theta_rad);
    fmt::format_to(std::back_inserter(text),
                   "{:.9f} {:.9f} 0 {:.6f} {:.9f} {:.9f} 0 {:.6f} 0 0 1 0\n",
                   c,
                   -s,
                   stamped.pose.x_m,
                   s,
                   c,
                   stamped.pose.y_m);
  }
  return text;
}

}  // namespace setsquare
