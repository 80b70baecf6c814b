// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "setsquare/matching/angle_histogram.hpp"
#include "setsquare/matching/surface_points.hpp"

namespace setsquare {

/// Weights of the points, in m, in which rare directions count for more: a wall's length divided by
/// the square root of the share of all walls that run its way; the sum stays. Along a corridor the
/// few door frames across it decide, not the metres of wall that fit anywhere (compare normal-space
/// sampling, Rusinkiewicz and Levoy 2001). Points without a line keep their weight.
[[nodiscard]] std::vector<float> direction_balanced_weights(const SurfacePoints& points,
                                                            const AngleHistogram& histogram);

}  // namespace setsquare
