// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <iostream>

#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/setsquare.hpp"

namespace {

/// Of a room of 8 x 6 m, from (x, 0) in its middle.
setsquare::Scan scan_at(double x_m) {
  setsquare::Scan scan;
  scan.stamp = setsquare::timestamp_from_seconds(10.0 + x_m);
  scan.first_bearing_rad = -setsquare::kPi;
  scan.bearing_step_rad = setsquare::rad_from_deg(1.0);
  scan.max_range_m = 50.0;
  for (int i = 0; i < 360; ++i) {
    const double bearing_rad = scan.first_bearing_rad + i * scan.bearing_step_rad;
    const double c = std::cos(bearing_rad);
    const double s = std::sin(bearing_rad);
    const double to_x_m = c > 0.0 ? (4.0 - x_m) / c : c < 0.0 ? (-4.0 - x_m) / c : 1e9;
    const double to_y_m = s != 0.0 ? 3.0 / std::abs(s) : 1e9;
    scan.ranges_m.push_back(std::min(to_x_m, to_y_m));
  }
  return scan;
}

}  // namespace

/// Matches, maps, saves and evaluates through one header.
int main() {
  const setsquare::MatchResult result = setsquare::match(scan_at(0.0), scan_at(0.5));
  std::cout << setsquare::to_string(result.status) << '\n';

  setsquare::MapperParams params;
  params.num_threads = 2;
  setsquare::Mapper mapper(params);
  for (int i = 0; i < 20; ++i) mapper.add(scan_at(0.1 * i));
  const setsquare::Map map = mapper.finish();
  const auto names = setsquare::save_map(map, "front_door_out", {.title = "A room"});
  const auto error =
      setsquare::evaluate(setsquare::trajectory_of(map),
                          setsquare::read_trajectory_tum("front_door_out/trajectory.tum"));
  std::cout << names.size() << " files, " << error.translation_m.max << " m\n";
  const auto& last = map.scans.back().T_map_base;
  const double way_m = std::hypot(last.x_m, last.y_m);
  return names.size() == 10 && std::abs(way_m - 1.9) < 0.1 && error.translation_m.max < 1e-5 ? 0
                                                                                             : 1;
}
