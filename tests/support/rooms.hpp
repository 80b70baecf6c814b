// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare::testing {

/// Walls from corner to corner and back to the first.
[[nodiscard]] std::vector<Wall> closed_polygon(const std::vector<Eigen::Vector2d>& corners_m);

/// A regular polygon about the origin; of many corners: a round room.
[[nodiscard]] std::vector<Wall> regular_polygon(int num_corners, double radius_m);

/// A rectangle from (0, 0), empty: a half turn about its middle maps it to itself.
[[nodiscard]] std::vector<Wall> empty_rectangle(double width_m, double height_m);

/// Two bare walls along x, 2.4 m apart, that end farther than any sensor sees: y from 0 to 2.4.
[[nodiscard]] std::vector<Wall> endless_corridor();

/// Two wings that meet at 60 deg with a few boxes in them: three wall families, not square.
[[nodiscard]] std::vector<Wall> oblique_room();

/// No two walls parallel, with clutter: seven corners, an oblique box and two short screens.
[[nodiscard]] std::vector<Wall> irregular_room();

/// A rectangle of 6 to 9 m by 5 to 8 m with a niche and six pieces of furniture of random size and
/// place, two of them oblique.
struct FurnishedRoom {
  std::vector<Wall> walls;
  double width_m = 0.0;
  double height_m = 0.0;
};
[[nodiscard]] FurnishedRoom furnished_room(std::mt19937_64& generator);

/// The end of a corridor 2.3 to 2.7 m wide, at x = 0, with doors in niches at random places on both
/// sides; at its other end, 9 to 13 m off, it opens into a hall. Walls of real corridors are not
/// quite parallel, nor are these.
[[nodiscard]] std::vector<Wall> end_of_a_corridor(std::mt19937_64& generator);

/// A random pose in it, 3 to 9 m from the end and facing it, within 35 deg.
[[nodiscard]] Pose2 pose_before_the_end(std::mt19937_64& generator);

/// A random pose in the room, at least 0.4 m from every wall and outside the furniture.
[[nodiscard]] Pose2 free_pose(const FurnishedRoom& room, std::mt19937_64& generator);

/// Share of the current scan's returns that, moved by the truth, lie within 0.2 m of a return of
/// the reference: what the two scans have in common.
[[nodiscard]] double true_overlap(const Scan& reference,
                                  const Scan& current,
                                  const Pose2& T_reference_current);

}  // namespace setsquare::testing
