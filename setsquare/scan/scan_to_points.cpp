// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/scan/scan_to_points.hpp"

#include <cmath>

namespace setsquare {

PointSet points_from_scan(const Scan& scan) {
  PointSet points;
  points.reserve(scan.num_beams());
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    if (scan.outcome(beam) != BeamOutcome::kReturn) continue;
    const double bearing_rad = scan.bearing_rad(beam);
    const double range_m = scan.ranges_m[beam];
    points.push_back(range_m * std::cos(bearing_rad),
                     range_m * std::sin(bearing_rad),
                     static_cast<std::int32_t>(beam));
  }
  return points;
}

}  // namespace setsquare
