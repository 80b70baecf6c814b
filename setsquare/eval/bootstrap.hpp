// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// How far the statistics of correlated errors are to be believed: the circular block bootstrap
// (Politis and Romano 1992).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace setsquare {

/// A statistic lies between these in nine of ten resampled sets of errors; in its unit.
struct ErrorBound {
  double low = 0.0;   ///< 5 % of the sets are below.
  double high = 0.0;  ///< 5 % of them are above.
};

/// Bounds of ErrorStatistics. The largest error has none: no resampled set exceeds it.
struct ErrorBounds {
  std::size_t block_length = 0;  ///< Errors that were drawn together.
  ErrorBound mean;               ///< Of the mean.
  ErrorBound rmse;               ///< Of the root mean square.
  ErrorBound median;             ///< Of the median.
  ErrorBound deviation;          ///< Of the standard deviation.
};

/// How errors are resampled.
struct BootstrapParams {
  std::size_t num_resamples = 1000;  ///< Sets that are drawn.
  std::size_t block_length = 0;      ///< Errors drawn together; 0: by their own correlation.
  std::uint64_t seed = 1;            ///< The same seed gives the same bounds.

  /// Throws ParameterError where there are fewer than 20 resamples.
  void validate() const;
};

/// Bounds of the statistics of errors in the order of time, of which there is at least one.
///
/// 1. Neighbouring errors are alike, so that n of them tell less than n independent ones. They are
///    drawn in blocks of consecutive ones, the first behind the last, which keeps the likeness.
/// 2. Each resampled set has as many errors as the measured one: blocks from places drawn at
///    random, the last one cut.
/// 3. Its statistics are taken; of all sets' those at 5 and 95 % are the bounds.
///
/// They tell how the figures vary with the stretches of this run; nothing of other runs, other
/// buildings, or of the truth's own errors. What was fitted before (an alignment) stays as it is.
[[nodiscard]] ErrorBounds bootstrap_bounds(std::span<const double> errors,
                                           const BootstrapParams& params = {});

/// The length of blocks by the errors' correlation, 1 where they are independent: Politis and White
/// 2004 with the correction of Patton et al. 2009, at most 3 sqrt(n) and n / 3.
[[nodiscard]] std::size_t block_length_of(std::span<const double> errors);

}  // namespace setsquare
