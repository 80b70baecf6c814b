// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/log_reader.hpp"

#include <fmt/core.h>

#include <cmath>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/io/logs/record_stream.hpp"

namespace setsquare {

std::string summary(const LogProblems& problems) {
  if (problems.num_damaged == 0) return {};
  const LogProblem& first = problems.first.front();
  const bool is_one = problems.num_damaged == 1;
  return fmt::format(
      "{} {}{}: {}",
      problems.num_damaged,
      is_one ? "damaged record skipped, at " : "damaged records skipped, the first at ",
      first.location,
      first.reason);
}

void LogOptions::validate() const {
  const auto is_in_turn = [](double angle_rad) { return angle_rad > 0.0 && angle_rad <= kTwoPi; };
  if (field_of_view_rad && !is_in_turn(*field_of_view_rad)) {
    throw ParameterError("field_of_view_rad", "must be above 0 and at most one turn");
  }
  if (bearing_step_rad && !is_in_turn(std::abs(*bearing_step_rad))) {
    throw ParameterError("bearing_step_rad", "must not be 0, and at most one turn");
  }
  for (const std::optional<double>& limit_s : {window.from_s, window.to_s}) {
    if (limit_s && !std::isfinite(*limit_s)) throw ParameterError("window", "must be finite");
  }
  if (window.max_rate_hz && !(*window.max_rate_hz > 0.0)) {
    throw ParameterError("window.max_rate_hz", "must be above 0");
  }
  if (slice.low_m.has_value() != slice.high_m.has_value() ||
      (slice.low_m && !(*slice.low_m < *slice.high_m))) {
    throw ParameterError("slice", "must have two heights, the lower one first");
  }
  for (const auto& [name, T_base_sensor] : mountings) {
    const double sum = T_base_sensor.x_m + T_base_sensor.y_m + T_base_sensor.theta_rad;
    if (!std::isfinite(sum)) throw ParameterError("mountings", name + " must be finite");
  }
  if (max_range_m && !(*max_range_m > 0.0)) {
    throw ParameterError("max_range_m", "must be above 0");
  }
  const auto is_positive = [](double number) { return number > 0.0 && std::isfinite(number); };
  if (angle_distance && !is_positive(angle_distance->range_unit_m)) {
    throw ParameterError("range_unit_m", "must be above 0");
  }
  if (angle_distance && !(angle_distance->rate_hz >= 1e-3 && angle_distance->rate_hz <= 1e6)) {
    throw ParameterError("rate_hz", "must be from 0.001 to a million");
  }
  if (!(range_scale > 0.0 && std::isfinite(range_scale))) {
    throw ParameterError("range_scale", "must be above 0 and finite");
  }
  if (sweep_time_s && !(std::abs(*sweep_time_s) <= kLongestSweep_s)) {
    throw ParameterError("sweep_time_s", "must be from -10 to 10 s");
  }
  for (const double range_m : ignored_ranges_m) {
    if (!(range_m > 0.0)) throw ParameterError("ignored_ranges_m", "must be above 0");
  }
}

}  // namespace setsquare
