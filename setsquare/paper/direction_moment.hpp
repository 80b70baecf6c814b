// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from dominant_direction, which shows it: one equation of the paper, one file.
#pragma once

#include <cstdint>
#include <span>

namespace setsquare {

/// The two readings of eq. (7). H is the Fourier transform of the profile, which is zero outside
/// its bins; omega is in rad per bin, so the integral ends at pi. Both are divided by pi.
enum class DirectionMoment {
  /// 4 sin^2(omega / 2) in place of omega^2: by Parseval the sum of the squared differences of
  /// neighbouring bins. The two agree at low frequencies.
  kNeighbourDifferences,
  /// omega^2 itself: by Parseval the sum over all pairs of bins of p_i p_j k(i - j), with
  /// k(0) = pi^2 / 3 and k(d) = 2 (-1)^d / d^2.
  kSquaredFrequency,
};

/// EvaluateDirection of the paper: the second moment M of the profile's power spectrum, eq. (7)
/// with |H|^2 (docs/method.md). In counts squared; 0 for an empty profile.
[[nodiscard]] double direction_moment(std::span<const std::int32_t> profile,
                                      DirectionMoment reading);

}  // namespace setsquare
