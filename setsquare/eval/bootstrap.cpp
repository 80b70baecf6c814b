// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/bootstrap.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <random>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/eval/error_statistics.hpp"

namespace setsquare {
namespace {

constexpr std::size_t kFewestResamples = 20;  // Else 5 % of them are less than one.
constexpr double kTail = 0.05;

/// Autocovariance of the values, less their mean, at a lag.
double autocovariance(std::span<const double> centred, std::size_t lag) {
  double sum = 0.0;
  for (std::size_t i = 0; i + lag < centred.size(); ++i) sum += centred[i] * centred[i + lag];
  return sum / static_cast<double>(centred.size());
}

/// The lag behind which the correlation is none: the first that is followed by so many of
/// correlations that chance explains. At most `max_lag`.
std::size_t last_correlated_lag(std::span<const double> centred,
                                double variance,
                                std::size_t max_lag) {
  const double num_log = std::log10(static_cast<double>(centred.size()));
  const auto num_in_a_row = std::max(std::size_t{5}, static_cast<std::size_t>(std::sqrt(num_log)));
  const double chance = 2.0 * std::sqrt(num_log / static_cast<double>(centred.size()));
  std::size_t num_small = 0;
  for (std::size_t lag = 1; lag <= max_lag; ++lag) {
    const bool is_small = std::abs(autocovariance(centred, lag) / variance) < chance;
    num_small = is_small ? num_small + 1 : 0;
    if (num_small == num_in_a_row) return lag - num_in_a_row;
  }
  return max_lag;
}

/// Weights of the lags in a spectral estimate: flat, then falling to zero.
double flat_top(double share) { return std::clamp(2.0 * (1.0 - share), 0.0, 1.0); }

/// The value below which the share of the values is; between two of them in proportion.
double quantile(std::vector<double>& values, double share) {
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

ErrorBound bound_of(const std::vector<ErrorStatistics>& sets, double ErrorStatistics::*statistic) {
  std::vector<double> values;
  values.reserve(sets.size());
  for (const ErrorStatistics& set : sets) values.push_back(set.*statistic);
  return {quantile(values, kTail), quantile(values, 1.0 - kTail)};
}

}  // namespace

void BootstrapParams::validate() const {
  if (num_resamples < kFewestResamples) {
    throw ParameterError("num_resamples", "must be 20 or more");
  }
}

std::size_t block_length_of(std::span<const double> errors) {
  const std::size_t num_errors = errors.size();
  if (num_errors < 4) return 1;
  const double mean = error_statistics(errors).mean;
  std::vector<double> centred(errors.begin(), errors.end());
  for (double& value : centred) value -= mean;
  const double variance = autocovariance(centred, 0);
  if (!(variance > 0.0)) return 1;
  const auto root = static_cast<std::size_t>(std::sqrt(static_cast<double>(num_errors)));
  const std::size_t longest = std::max(std::size_t{1}, std::min(3 * root, num_errors / 3));
  const std::size_t max_lag =
      std::min(2 * last_correlated_lag(centred, variance, longest), num_errors - 1);
  if (max_lag == 0) return 1;
  double spectrum = variance;  // At frequency zero ...
  double slope = 0.0;          // ... and how it falls off.
  for (std::size_t lag = 1; lag <= max_lag; ++lag) {
    const double weight = flat_top(static_cast<double>(lag) / static_cast<double>(max_lag));
    const double both_ways = 2.0 * weight * autocovariance(centred, lag);
    spectrum += both_ways;
    slope += static_cast<double>(lag) * both_ways;
  }
  const double spread = 4.0 / 3.0 * spectrum * spectrum;
  if (!(spread > 0.0)) return 1;
  const double length = std::cbrt(2.0 * slope * slope / spread * static_cast<double>(num_errors));
  return static_cast<std::size_t>(std::clamp(std::ceil(length), 1.0, static_cast<double>(longest)));
}

ErrorBounds bootstrap_bounds(std::span<const double> errors, const BootstrapParams& params) {
  params.validate();
  assert(!errors.empty());
  const std::size_t num_errors = errors.size();
  const std::size_t length =
      std::min(params.block_length > 0 ? params.block_length : block_length_of(errors), num_errors);
  std::mt19937_64 random(params.seed);
  std::vector<double> drawn(num_errors);
  std::vector<ErrorStatistics> sets;
  sets.reserve(params.num_resamples);
  for (std::size_t set = 0; set < params.num_resamples; ++set) {
    for (std::size_t i = 0; i < num_errors;) {
      // The remainder favours no place by more than 1e-12: there are far fewer errors than numbers.
      const std::size_t start = random() % num_errors;
      for (std::size_t k = 0; k < length && i < num_errors; ++k) {
        drawn[i++] = errors[(start + k) % num_errors];
      }
    }
    sets.push_back(error_statistics(drawn));
  }
  return {.block_length = length,
          .mean = bound_of(sets, &ErrorStatistics::mean),
          .rmse = bound_of(sets, &ErrorStatistics::rmse),
          .median = bound_of(sets, &ErrorStatistics::median),
          .deviation = bound_of(sets, &ErrorStatistics::deviation)};
}

}  // namespace setsquare
