// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "setsquare/paper/projected_profile.hpp"

namespace setsquare {

/// The shifts lambda that Algorithm 3 tries along an axis: multiples of the step, both ways.
struct ShiftSearch {
  double max_shift_m = 2.5;  ///< lambda_max.
  double step_m = 0.005;     ///< Delta lambda; divides the bin width.

  /// Lags run from -max_lag() to max_lag().
  [[nodiscard]] std::int64_t max_lag() const;
  /// The shift of value `index` of correlate(), in m.
  [[nodiscard]] double shift_m(std::size_t index) const {
    return static_cast<double>(static_cast<std::int64_t>(index) - max_lag()) * step_m;
  }
  /// Throws ParameterError unless the step is positive and divides the shift and the bin width.
  void validate(const ProfileBins& bins) const;
};

/// Cross-correlation of eq. (10) against lambda, one value per lag from -max_lag() to max_lag():
/// Corr(lambda) = sum over the bins of P_reference(kappa) P_current(lambda, kappa), where the
/// current profile of eq. (9) counts the current coordinates moved by lambda. Exact integers.
[[nodiscard]] std::vector<std::int32_t> correlate(const ProjectedProfile& reference,
                                                  std::span<const double> current_coordinates_m,
                                                  const ShiftSearch& search);

/// Index of the first largest value, as Algorithm 3 keeps it; lag 0's where nothing correlates.
[[nodiscard]] std::size_t first_peak(std::span<const std::int32_t> correlation);

}  // namespace setsquare
