// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/carmen/scan_geometry.hpp"

#include <cmath>

namespace setsquare {

void set_symmetric_bearings(Scan& scan, const LogOptions& options) {
  const auto num_beams = static_cast<double>(scan.num_beams());
  const bool is_by_step = options.bearing_step_rad && !options.field_of_view_rad;
  const double field_of_view_rad = is_by_step
                                       ? std::abs(*options.bearing_step_rad) * (num_beams - 1.0)
                                       : options.field_of_view_rad.value_or(kPi);
  const bool is_odd = scan.num_beams() % 2 == 1;
  const double num_steps = is_odd && scan.num_beams() > 1 ? num_beams - 1.0 : num_beams;
  scan.bearing_step_rad = options.bearing_step_rad.value_or(field_of_view_rad / num_steps);
  scan.first_bearing_rad =
      scan.bearing_step_rad < 0.0 ? 0.5 * field_of_view_rad : -0.5 * field_of_view_rad;
}

void set_stated_bearings(Scan& scan, double start_rad, double field_of_view_rad, double step_rad) {
  scan.first_bearing_rad = start_rad;
  scan.bearing_step_rad = step_rad;
  if (step_rad == 0.0 && scan.num_beams() > 1) {
    scan.bearing_step_rad = field_of_view_rad / static_cast<double>(scan.num_beams() - 1);
  }
}

double max_range_from_stated(double stated_m) {
  constexpr double kSickFirstErrorCode_m = 81.83;
  constexpr double kSickLastErrorCode_m = 81.92;
  if (!(stated_m > 0.0)) return kSickLowestCode_m;
  const bool is_sick_code = stated_m > kSickFirstErrorCode_m && stated_m <= kSickLastErrorCode_m;
  return is_sick_code ? kSickFirstErrorCode_m : stated_m;
}

}  // namespace setsquare
