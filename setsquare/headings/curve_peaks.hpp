// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from square_direction, its only caller, because tests try it on their own curves.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace setsquare {

/// A local maximum of a circular curve.
struct CurvePeak {
  double position = 0.0;   ///< In samples, in [0, size): the vertex of the parabola through three.
  double value = 0.0;      ///< The largest sample.
  double over_mean = 0.0;  ///< The value over the curve's mean: 1 where the curve is flat.
};

/// The highest local maxima of a circular curve, highest first, no two nearer than
/// `min_separation` samples; among equal ones the first. None where the curve is nowhere positive.
[[nodiscard]] std::vector<CurvePeak> highest_peaks(std::span<const double> curve,
                                                   std::size_t max_num_peaks,
                                                   std::size_t min_separation);

}  // namespace setsquare
