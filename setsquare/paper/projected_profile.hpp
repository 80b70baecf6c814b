// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "setsquare/scan/point_set.hpp"

namespace setsquare {

/// The bins of a projected profile: equal, side by side, over [-max_distance_m, max_distance_m].
struct ProfileBins {
  double bin_width_m = 0.04;     ///< Delta rho of the paper.
  double max_distance_m = 10.0;  ///< d_max of the paper.

  /// `len` of the paper: the bins that cover the range.
  [[nodiscard]] std::size_t num_bins() const {
    return static_cast<std::size_t>(std::lround(2.0 * max_distance_m / bin_width_m));
  }
  /// Throws ParameterError unless both are positive and the width divides the range.
  void validate() const;
};

/// Number of points in each bin along one direction. Bin kappa holds the coordinates in
/// (kappa * width - max_distance, (kappa + 1) * width - max_distance]: eq. (6).
struct ProjectedProfile {
  ProfileBins bins;                  ///< Those that `counts` belongs to.
  std::vector<std::int32_t> counts;  ///< One per bin.

  /// Points within the bins' range.
  [[nodiscard]] std::int64_t mass() const {
    return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
  }
};

/// Coordinate of every point along the projection axis, in m, one per point: eq. (4),
/// rho = d sin(phi + theta), that is the coordinate along (sin theta, cos theta): y once the scan
/// is turned by theta about the sensor.
[[nodiscard]] std::vector<double> project(const PointSet& points, double theta_rad);

/// Counts coordinates in bins: eqs. (5) and (6), of coordinates moved by `shift_m`: eq. (9).
/// Coordinates outside the bins' range are not counted.
[[nodiscard]] ProjectedProfile profile_of_coordinates(std::span<const double> coordinates_m,
                                                      const ProfileBins& bins,
                                                      double shift_m = 0.0);

/// GetProjectedProfile of the paper, eqs. (4)-(6).
[[nodiscard]] ProjectedProfile projected_profile(const PointSet& points,
                                                 double theta_rad,
                                                 const ProfileBins& bins = {});

}  // namespace setsquare
