// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// One scan located in a known map, nothing known of where it was taken.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "benchmarks/localisation/places.hpp"
#include "setsquare/localisation/place_search.hpp"
#include "setsquare/surfaces/angle_histogram.hpp"

namespace setsquare::experiments {
namespace {

void run_dump(const KnownPlace& place, int group) {
  static int id = 0;
  ++id;
  const auto start = std::chrono::steady_clock::now();
  const SoughtScan sought = sought_scan(place.scan);
  const auto thorough = search_places(place.map, sought);
  const double all_ms =
      1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  int pass = 0;
  if (place.T_map_sensor) {
    const Pose2 T = place.map.T_map_grid().inverse() * *place.T_map_sensor;
    const auto st = place.map.walls().state(place.map.walls().cell_at(T.x_m, T.y_m));
    std::size_t known = 0, total = 0;
    for (std::size_t b = 0; b < place.scan.num_beams(); b += 4) {
      if (place.scan.outcome(b) != BeamOutcome::kReturn) continue;
      const Eigen::Vector2d at = T * (place.scan.ranges_m[b] * Eigen::Vector2d(std::cos(place.scan.bearing_rad(b)), std::sin(place.scan.bearing_rad(b))));
      ++total;
      known += place.map.walls().state(place.map.walls().cell_at(at.x(), at.y())) != CellState::kUnknown || place.map.walls().slope_at(float(at.x()), float(at.y())).distance_m < 0.15F;
    }
    std::printf("K %d %d %.3f %.3f\n", id, st == CellState::kFree, total ? double(known) / double(total) : 0.0, T.x_m);
  }
  {
    pass = 1;
    std::printf("S %d %d %d %.2f %.2f %d\n", id, group, pass, all_ms, all_ms, place.T_map_sensor.has_value());
    for (const VerifiedPlace& p : thorough) {
      double error_m = 99.0;
      double error_deg = 180.0;
      if (place.T_map_sensor) {
        const Pose2 e = place.T_map_sensor->inverse() * (place.map.T_map_grid() * p.T_grid_sensor);
        error_m = std::hypot(e.x_m, e.y_m);
        error_deg = std::abs(e.theta_rad) * 57.29578;
      }
      std::printf("P %d %d %.3f %.2f %.4f %.4f", id, pass, error_m, error_deg, p.fit, p.score);
      const auto& c = p.constraint;
      std::printf(" %.4g %.4g %.4g %.4g", p.distinct_wall_m, c.all_m, c.open_direction_m, c.turning_m3);
      for (const WallKinds& k : {p.kinds.forward, p.kinds.backward}) {
        std::printf(" %.4g %.4g %.4g %.4g %.4g %.4g %.4g %.4g", k.wall_m, k.tight_m, k.loose_m, k.clutter_m,
                  k.contradicted_m, k.hidden_m, k.unexplained_m, k.outside_m);
      }
      std::printf("\n");
    }
  }
}

}  // namespace
}  // namespace setsquare::experiments

int main(int argc, char** argv) {
  using namespace setsquare;
  using namespace setsquare::experiments;
  const std::string mode = argc > 1 ? argv[1] : "";
  if (mode == "image") {
    const double fov = std::atof(argv[3]);
    const auto scanner = still_scanner(rad_from_deg(fov), fov > 359 ? 720 : 1081, std::atof(argv[4]), 10.0);
    visit_map_image(argv[2], scanner, std::atoi(argv[5]), 1, [](const KnownPlace& p) { run_dump(p, 0); });
  } else if (mode == "half") {
    visit_second_half(argv[2], std::atof(argv[3]), [](const KnownPlace& p) { run_dump(p, 1); });
  } else if (mode == "sim") {
    const int seeds = std::atoi(argv[3]);
    for (int s = std::atoi(argv[2]); s < std::atoi(argv[2]) + seeds; ++s) {
      int group = 10;
      for (const auto c : kAllBuildingClasses) {
        for (const bool stranger : {false, true}) {
          int which = 0;
          for (const auto& scanner : {utm_30lx(), still_scanner(kPi, 181, 0.02, 30.0), low_cost_360(),
                                      still_scanner(kTwoPi, 360, 0.05, 10.0)}) {
            visit_building(c, s, scanner, 8, stranger,
                           [&](const KnownPlace& p) { run_dump(p, group + which * 100); });
            ++which;
          }
        }
        ++group;
      }
    }
  }
  return 0;
}
