// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/svg/flattened_curve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace setsquare {
namespace {

/// Chords for a parameter that runs from 0 to 1; a curve that turns much gets some at any size.
int num_chords(double largest_second_derivative_m, double tolerance_m, double least) {
  constexpr double kMost = 4096.0;
  const double wanted = std::ceil(std::sqrt(largest_second_derivative_m / (8.0 * tolerance_m)));
  // Not std::clamp alone: NaN must become a number.
  return static_cast<int>(wanted > least ? std::min(wanted, kMost) : least);
}

}  // namespace

void append_arc(Corners& corners, const EllipseArc& arc, double tolerance_m) {
  const double radius_m = std::hypot(arc.first_axis_m.norm(), arc.second_axis_m.norm());
  const double turn = std::abs(arc.sweep_rad);
  // No fewer than eight corners around.
  const int count = num_chords(radius_m * turn * turn, tolerance_m, std::ceil(turn / 0.786));
  for (int i = 1; i <= count; ++i) {
    const double t_rad = arc.start_rad + arc.sweep_rad * i / count;
    corners.emplace_back(arc.center_m + std::cos(t_rad) * arc.first_axis_m +
                         std::sin(t_rad) * arc.second_axis_m);
  }
}

void append_quadratic(Corners& corners,
                      const Eigen::Vector2d& control_m,
                      const Eigen::Vector2d& end_m,
                      double tolerance_m) {
  assert(!corners.empty());
  const Eigen::Vector2d start_m = corners.back();
  append_cubic(corners,
               start_m + 2.0 / 3.0 * (control_m - start_m),
               end_m + 2.0 / 3.0 * (control_m - end_m),
               end_m,
               tolerance_m);
}

void append_cubic(Corners& corners,
                  const Eigen::Vector2d& first_control_m,
                  const Eigen::Vector2d& second_control_m,
                  const Eigen::Vector2d& end_m,
                  double tolerance_m) {
  assert(!corners.empty());
  const Eigen::Vector2d start_m = corners.back();
  const double bend_m = std::max((start_m - 2.0 * first_control_m + second_control_m).norm(),
                                 (first_control_m - 2.0 * second_control_m + end_m).norm());
  const int count = num_chords(6.0 * bend_m, tolerance_m, 1.0);
  for (int i = 1; i <= count; ++i) {
    const double t = static_cast<double>(i) / count;
    const double s = 1.0 - t;
    corners.emplace_back(s * s * s * start_m + 3.0 * s * s * t * first_control_m +
                         3.0 * s * t * t * second_control_m + t * t * t * end_m);
  }
}

}  // namespace setsquare
