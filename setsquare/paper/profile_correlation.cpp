// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/paper/profile_correlation.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

bool is_multiple(double value, double unit) {
  const double ratio = value / unit;
  return ratio <= 1e6 && std::abs(ratio - std::round(ratio)) < 1e-6;
}

/// The reference's counts with empty bins on both sides, so that no shift needs a test.
struct PaddedCounts {
  std::int64_t margin = 0;
  std::vector<std::int32_t> counts;

  PaddedCounts(const ProjectedProfile& profile, std::int64_t margin_bins)
      : margin(margin_bins), counts(profile.counts.size() + 2 * static_cast<std::size_t>(margin)) {
    std::copy(profile.counts.begin(), profile.counts.end(), counts.begin() + margin);
  }
};

/// Sum of the combs at num_lags lags from `first_phase` on: value n is the sum over q of
/// comb_q[(first_phase + n + q) / steps]. From one lag to the next only one comb moves on.
std::vector<std::int32_t> sum_of_combs(const std::vector<std::int32_t>& combs,
                                       std::int64_t comb_size,
                                       std::int64_t steps,
                                       std::int64_t first_phase,
                                       std::int64_t num_lags) {
  std::vector<std::int32_t> sums;
  sums.reserve(static_cast<std::size_t>(num_lags));
  std::int32_t sum = 0;
  for (std::int64_t q = 0; q < steps; ++q) {
    sum += combs[static_cast<std::size_t>(q * comb_size + (first_phase + q) / steps)];
  }
  sums.push_back(sum);
  std::int64_t q = steps - 1 - first_phase % steps;  // The comb that moves on next ...
  std::int64_t tooth = first_phase / steps + 1;      // ... to this tooth.
  while (static_cast<std::int64_t>(sums.size()) < num_lags) {
    const auto moved = static_cast<std::size_t>(q * comb_size + tooth);
    sum += combs[moved] - combs[moved - 1];
    sums.push_back(sum);
    if (--q < 0) {
      q = steps - 1;
      ++tooth;
    }
  }
  return sums;
}

}  // namespace

std::int64_t ShiftSearch::max_lag() const { return std::llround(max_shift_m / step_m); }

void ShiftSearch::validate(const ProfileBins& bins) const {
  if (!(step_m > 0.0) || !is_multiple(bins.bin_width_m, step_m)) {
    throw ParameterError("shift_step_m", "must be positive and divide bin_width_m");
  }
  if (!(max_shift_m >= 0.0) || !is_multiple(max_shift_m, step_m)) {
    throw ParameterError("max_shift_m", "must be a multiple of shift_step_m, not negative");
  }
}

std::vector<std::int32_t> correlate(const ProjectedProfile& reference,
                                    std::span<const double> current_coordinates_m,
                                    const ShiftSearch& search) {
  // A bin holds `steps` steps. A coordinate at step q of its bin stays in the bin for the next
  // q lags and then meets the bin above, so eq. (10) at 5 mm falls into `steps` correlations at
  // bin width, one for the points of each q: comb_q[t] = sum of P_reference(own bin + t).
  const auto steps = std::llround(reference.bins.bin_width_m / search.step_m);
  const auto num_bins = static_cast<std::int64_t>(reference.counts.size());
  const std::int64_t max_lag = search.max_lag();
  const std::int64_t reach = max_lag / steps + 1;  // Bins that a shift may cross, either way.
  const std::int64_t comb_size = 2 * reach + 1;
  const PaddedCounts padded(reference, 2 * reach);
  std::vector<std::int32_t> combs(static_cast<std::size_t>(steps * comb_size), 0);
  for (const double rho_m : current_coordinates_m) {
    const double from_end = (reference.bins.max_distance_m - rho_m) / search.step_m;
    const double step = static_cast<double>(num_bins * steps - 1) - std::floor(from_end);
    if (!(std::abs(step) < static_cast<double>((num_bins + reach) * steps))) continue;
    const auto whole_step = static_cast<std::int64_t>(step) + reach * steps;
    if (whole_step < 0 || whole_step >= (num_bins + 2 * reach) * steps) continue;  // Never reaches.
    const std::int64_t bin = whole_step / steps - reach;
    const std::int32_t* const met = padded.counts.data() + (bin - reach + padded.margin);
    std::int32_t* const comb = combs.data() + (whole_step % steps) * comb_size;
    for (std::int64_t t = 0; t < comb_size; ++t) comb[t] += met[t];
  }
  return sum_of_combs(combs, comb_size, steps, reach * steps - max_lag, 2 * max_lag + 1);
}

std::size_t first_peak(std::span<const std::int32_t> correlation) {
  const auto best = std::max_element(correlation.begin(), correlation.end());
  if (best == correlation.end() || *best == 0) return correlation.size() / 2;
  return static_cast<std::size_t>(best - correlation.begin());
}

}  // namespace setsquare
