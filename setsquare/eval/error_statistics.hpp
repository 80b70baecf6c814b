// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "setsquare/eval/bootstrap.hpp"

namespace setsquare {

/// Summary of a set of errors. The deviation is that of the set (divided by n, as evo does),
/// so that rmse^2 = mean^2 + deviation^2; all are 0 for an empty set.
struct ErrorStatistics {
  std::size_t num_values = 0;  ///< How many errors there were.
  double mean = 0.0;           ///< Their sum divided by their number.
  double rmse = 0.0;           ///< The root of the mean of their squares.
  double median = 0.0;         ///< The mean of the middle two where there are two.
  double max = 0.0;            ///< The largest.
  double deviation = 0.0;      ///< Standard deviation about the mean, divided by n.
  std::optional<ErrorBounds> bounds = std::nullopt;  ///< Where they were asked for.
};

/// The statistics of values that are not negative, in their unit.
[[nodiscard]] ErrorStatistics error_statistics(std::span<const double> values);

/// The same with bounds, where they are asked for and there is a value; values in the order of
/// time.
[[nodiscard]] ErrorStatistics error_statistics(std::span<const double> values,
                                               const std::optional<BootstrapParams>& bootstrap);

}  // namespace setsquare
