// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace setsquare {

/// Arc tangent of y / x over the whole circle, in [-pi, pi], within 0.005 rad: for bins and for
/// products with something small.
[[nodiscard]] inline float approximate_bearing(float y, float x) {
  const float ax = std::abs(x);
  const float ay = std::abs(y);
  const float ratio = std::min(ax, ay) / (std::max(ax, ay) + 1e-12F);
  const float octant = ratio * (1.0584F - ratio * 0.273F);
  const float quadrant = ay > ax ? 1.57079633F - octant : octant;
  const float half = x < 0.0F ? 3.14159265F - quadrant : quadrant;
  return y < 0.0F ? -half : half;
}

}  // namespace setsquare
