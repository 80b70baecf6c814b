// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/scan/scan.hpp"

#include <cmath>

#include "setsquare/core/error.hpp"
#include "setsquare/scan/housing.hpp"

namespace setsquare {

double Scan::field_of_view_rad() const {
  if (ranges_m.empty()) return 0.0;
  return std::abs(bearing_step_rad) * static_cast<double>(ranges_m.size() - 1);
}

BeamOutcome Scan::outcome(std::size_t beam) const {
  const double range_m = ranges_m[beam];
  if (std::isnan(range_m) || range_m < kHousingRadius_m || range_m < min_range_m) {
    return BeamOutcome::kInvalid;
  }
  if (range_m >= max_range_m || std::isinf(range_m)) return BeamOutcome::kNoReturn;
  return BeamOutcome::kReturn;
}

void Scan::validate() const {
  if (!std::isfinite(first_bearing_rad)) {
    throw ParameterError("first_bearing_rad", "must be finite");
  }
  if (!std::isfinite(bearing_step_rad) || (num_beams() > 1 && bearing_step_rad == 0.0)) {
    throw ParameterError("bearing_step_rad", "must be finite and not zero");
  }
  constexpr double kRoundingSlack_rad = 1e-3;
  if (field_of_view_rad() > kTwoPi + kRoundingSlack_rad) {
    throw ParameterError("bearing_step_rad", "the beams sweep more than one turn");
  }
  if (!(min_range_m >= 0.0) || !(max_range_m > min_range_m)) {
    throw ParameterError("max_range_m", "must be above min_range_m, which must not be negative");
  }
}

}  // namespace setsquare
