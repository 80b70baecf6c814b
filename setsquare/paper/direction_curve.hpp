// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/paper/projected_profile.hpp"
#include "setsquare/scan/point_set.hpp"

namespace setsquare {

/// Equally spaced directions: theta_j = first + j * step.
struct DirectionGrid {
  double first_rad = 0.0;          ///< Of direction 0.
  double step_rad = 0.0;           ///< From one direction to the next.
  std::size_t num_directions = 0;  ///< How many there are.

  /// Of number j, counted from 0.
  [[nodiscard]] double direction_rad(std::size_t j) const {
    return first_rad + static_cast<double>(j) * step_rad;
  }
};

/// M(theta_j) for every direction of the grid, one per direction, with neighbour differences for
/// eq. (7): direction_moment(projected_profile(points, theta_j, bins), kNeighbourDifferences), at
/// a hundredth of its cost. (A coordinate within rounding of a bin's edge may fall on either side.)
[[nodiscard]] std::vector<double> direction_curve(const PointSet& points,
                                                  const DirectionGrid& grid,
                                                  const ProfileBins& bins = {});

/// As direction_curve, with an upper bound of the moment with omega^2 itself, from the
/// sums of squared first and second differences of neighbouring bins.
struct DirectionCurves {
  std::vector<double> neighbour_differences;    ///< A lower bound of the moment with omega^2.
  std::vector<double> squared_frequency_bound;  ///< An upper one.
};
/// Both bounds for every direction of the grid, from the same profiles as direction_curve().
[[nodiscard]] DirectionCurves direction_curves(const PointSet& points,
                                               const DirectionGrid& grid,
                                               const ProfileBins& bins = {});

}  // namespace setsquare
