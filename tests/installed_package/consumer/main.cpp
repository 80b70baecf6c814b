// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "setsquare/core/angle.hpp"
#include "setsquare/paper/thinning.hpp"
#include "setsquare/scan/match_result.hpp"
#include "setsquare/scan/scan.hpp"
#include "setsquare/scan/scan_to_points.hpp"

/// Uses a header and a compiled function of each layer that the package exports.
int main() {
  setsquare::Scan scan;
  scan.first_bearing_rad = setsquare::rad_from_deg(-90.0);
  scan.bearing_step_rad = setsquare::rad_from_deg(1.0);
  scan.ranges_m.assign(181, 2.0);
  const setsquare::PointSet points = setsquare::thin(setsquare::points_from_scan(scan), 0.08);
  std::cout << points.size() << " points, "
            << setsquare::to_string(setsquare::MatchStatus::kMatched) << '\n';
  return points.size() > 50 && points.size() < scan.num_beams() ? 0 : 1;
}
