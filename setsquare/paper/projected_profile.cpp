// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/paper/projected_profile.hpp"

#include "setsquare/core/error.hpp"

namespace setsquare {

void ProfileBins::validate() const {
  if (!(bin_width_m > 0.0) || !std::isfinite(bin_width_m)) {
    throw ParameterError("bin_width_m", "must be positive");
  }
  if (!(max_distance_m > 0.0) || !std::isfinite(max_distance_m)) {
    throw ParameterError("max_distance_m", "must be positive");
  }
  const double num_widths = 2.0 * max_distance_m / bin_width_m;
  if (num_widths > 1e6 || std::abs(num_widths - std::round(num_widths)) > 1e-6) {
    throw ParameterError("bin_width_m", "must divide 2 * max_distance_m into at most 1e6 bins");
  }
}

std::vector<double> project(const PointSet& points, double theta_rad) {
  const double s = std::sin(theta_rad);
  const double c = std::cos(theta_rad);
  std::vector<double> coordinates_m(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    coordinates_m[i] = points.x_m[i] * s + points.y_m[i] * c;  // Eq. (4)
  }
  return coordinates_m;
}

ProjectedProfile profile_of_coordinates(std::span<const double> coordinates_m,
                                        const ProfileBins& bins,
                                        double shift_m) {
  const std::size_t num_bins = bins.num_bins();
  ProjectedProfile profile{bins, std::vector<std::int32_t>(num_bins, 0)};
  const double inverse_width = 1.0 / bins.bin_width_m;
  for (const double rho_m : coordinates_m) {
    // Eq. (6): bins are open below and closed above, so they are counted from the upper end.
    const double from_end = (bins.max_distance_m - (rho_m + shift_m)) * inverse_width;
    if (from_end >= 0.0 && from_end < static_cast<double>(num_bins)) {
      ++profile.counts[num_bins - 1 - static_cast<std::size_t>(from_end)];  // Eq. (5)
    }
  }
  return profile;
}

ProjectedProfile projected_profile(const PointSet& points,
                                   double theta_rad,
                                   const ProfileBins& bins) {
  return profile_of_coordinates(project(points, theta_rad), bins);
}

}  // namespace setsquare
