// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "setsquare/core/angle.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/paper/paper_matcher.hpp"
#include "setsquare/paper/thinning.hpp"
#include "setsquare/scan/scan_to_points.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

/// Uses the second level: scans prepared once, and the paper's functions.
int main() {
  setsquare::Scan scan;
  scan.first_bearing_rad = setsquare::rad_from_deg(-90.0);
  scan.bearing_step_rad = setsquare::rad_from_deg(1.0);
  scan.max_range_m = 50.0;
  scan.ranges_m.assign(181, 2.0);
  const setsquare::PointSet points = setsquare::thin(setsquare::points_from_scan(scan), 0.08);
  const setsquare::PreparedScan prepared = setsquare::prepare(scan);
  const setsquare::MatchResult result = setsquare::match(prepared, prepared);
  const setsquare::MatchResult by_paper =
      setsquare::match_paper(setsquare::prepare_paper(scan), setsquare::prepare_paper(scan));
  std::cout << points.size() << " points, " << setsquare::to_string(result.status) << ", "
            << setsquare::to_string(by_paper.status) << '\n';
  return points.size() > 50 && points.size() < scan.num_beams() ? 0 : 1;
}
