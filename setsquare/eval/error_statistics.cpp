// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/error_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "setsquare/core/median.hpp"

namespace setsquare {

ErrorStatistics error_statistics(std::span<const double> values) {
  if (values.empty()) return {};
  const auto num_values = static_cast<double>(values.size());
  double sum = 0.0;
  double sum_of_squares = 0.0;
  for (const double value : values) {
    sum += value;
    sum_of_squares += value * value;
  }
  const double mean = sum / num_values;
  double squared_deviations = 0.0;
  for (const double value : values) squared_deviations += (value - mean) * (value - mean);
  return {values.size(),
          mean,
          std::sqrt(sum_of_squares / num_values),
          median({values.begin(), values.end()}),
          *std::max_element(values.begin(), values.end()),
          std::sqrt(squared_deviations / num_values)};
}

ErrorStatistics error_statistics(std::span<const double> values,
                                 const std::optional<BootstrapParams>& bootstrap) {
  ErrorStatistics statistics = error_statistics(values);
  if (bootstrap && !values.empty()) statistics.bounds = bootstrap_bounds(values, *bootstrap);
  return statistics;
}

}  // namespace setsquare
