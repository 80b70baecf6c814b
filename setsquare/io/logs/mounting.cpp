// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/mounting.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "setsquare/core/median.hpp"

namespace setsquare {
namespace {

constexpr double kFinestUnit_m = 1e-4;
constexpr double kFinestUnit_rad = 1e-6;

double settle(double value, double rounding, double finest_unit) {
  if (rounding <= 0.0) return value;
  const double unit = std::max(rounding, finest_unit);
  if (std::abs(value) <= 1.5 * unit) return 0.0;
  return std::round(value / unit) * unit;
}

}  // namespace

Pose2 settle_mounting(std::vector<Pose2> mountings, double rounding) {
  if (mountings.empty()) return {};
  std::vector<double> x_m;
  std::vector<double> y_m;
  std::vector<double> turn_rad;  // from the first: no wrapping between values around pi
  const double reference_rad = mountings.front().theta_rad;
  for (const Pose2& mounting : mountings) {
    x_m.push_back(mounting.x_m);
    y_m.push_back(mounting.y_m);
    turn_rad.push_back(wrap_to_pi(mounting.theta_rad - reference_rad));
  }
  const double heading_rad = wrap_to_pi(reference_rad + upper_median(std::move(turn_rad)));
  return {settle(median(std::move(x_m)), rounding, kFinestUnit_m),
          settle(median(std::move(y_m)), rounding, kFinestUnit_m),
          settle(heading_rad, rounding, kFinestUnit_rad)};
}

bool is_mounting_varying(const Pose2& settled, const Pose2& measured, double rounding) {
  constexpr double kMaxDistance_m = 0.05;
  constexpr double kMaxTurn_rad = 0.035;
  const double slack = 3.0 * rounding;
  return std::hypot(measured.x_m - settled.x_m, measured.y_m - settled.y_m) >
             kMaxDistance_m + slack ||
         std::abs(wrap_to_pi(measured.theta_rad - settled.theta_rad)) > kMaxTurn_rad + slack;
}

}  // namespace setsquare
