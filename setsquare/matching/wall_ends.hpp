// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from same_place, its only caller: the ends, tested on walls drawn by hand.
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <vector>

#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {

/// Where a surface ends before something farther: a door jamb, the corner of a cupboard, a post.
struct WallEnd {
  Eigen::Vector2d at_m;       ///< In the sensor's frame.
  Eigen::Vector2d into_wall;  ///< Unit vector from the end along its wall; zero where no line fits.
};

/// The ends that a scan shows, in the order of the beams.
[[nodiscard]] std::vector<WallEnd> wall_ends(const SurfacePoints& points);

/// Ends of one scan's walls that the other scan must show, too.
struct WallEndCount {
  std::size_t agreeing = 0;  ///< It shows one there, of a wall on the same side.
  std::size_t missing = 0;   ///< It sees the place, and shows none.
};

/// Both ways summed. What is hidden, or outside the other's view, is not counted.
[[nodiscard]] WallEndCount compare_wall_ends(const PreparedScan& reference,
                                             const PreparedScan& current,
                                             const Pose2& T_reference_current);

}  // namespace setsquare
