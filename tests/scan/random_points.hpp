// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "setsquare/scan/point_set.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::testing {

/// Points strewn evenly over a square about the sensor.
inline PointSet random_points(std::mt19937_64& generator,
                              std::size_t num_points,
                              double half_width_m) {
  PointSet points;
  for (std::size_t i = 0; i < num_points; ++i) {
    points.push_back(uniform(generator, -half_width_m, half_width_m),
                     uniform(generator, -half_width_m, half_width_m),
                     static_cast<std::int32_t>(i));
  }
  return points;
}

/// The points as a sensor sees them that has turned by the angle.
inline PointSet seen_after_turn(const PointSet& points, double turn_rad) {
  const double c = std::cos(turn_rad);
  const double s = std::sin(turn_rad);
  PointSet turned;
  for (std::size_t i = 0; i < points.size(); ++i) {
    turned.push_back(c * points.x_m[i] + s * points.y_m[i],
                     -s * points.x_m[i] + c * points.y_m[i],
                     points.beam[i]);
  }
  return turned;
}

}  // namespace setsquare::testing
