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
  std::vector<double> rotations;
  for (const auto& r : propose_rotations(place.map.directions(), sought.prepared.histogram, 8)) {
    rotations.push_back(r.rotation_rad);
  }
  const auto quick = search_places(place.map, sought, rotations, {});
  const double quick_ms =
      1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::vector<double> circle;
  for (int i = 0; i < 120; ++i) circle.push_back(wrap_to_pi(i * kTwoPi / 120));
  const auto thorough = search_places(place.map, sought, circle, {});
  const double all_ms =
      1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  int pass = 0;
  if (place.T_map_sensor) {
    const Pose2 T = place.map.T_map_grid().inverse() * *place.T_map_sensor;
    const VerifiedPlace p = verified_place(place.map, sought, T);
    const Pose2 e = T.inverse() * p.T_grid_sensor;
    std::printf("T %d %.3f %.2f %.4f %.4f\n", id, std::hypot(e.x_m, e.y_m), std::abs(e.theta_rad) * 57.29578, fit_at_place(place.map, sought, p.T_grid_sensor), p.score);
  }
  for (const auto* found : {&quick, &thorough}) {
    if (found == &quick && std::getenv("ALL") == nullptr) { ++pass; continue; }
    std::printf("S %d %d %d %.2f %.2f %d\n", id, group, pass, quick_ms, all_ms,
                place.T_map_sensor.has_value());
    for (const VerifiedPlace& p : *found) {
      double error_m = 99.0;
      double error_deg = 180.0;
      if (place.T_map_sensor) {
        const Pose2 e = place.T_map_sensor->inverse() * (place.map.T_map_grid() * p.T_grid_sensor);
        error_m = std::hypot(e.x_m, e.y_m);
        error_deg = std::abs(e.theta_rad) * 57.29578;
      }
      std::printf("P %d %d %.3f %.2f %.4f %.4f", id, pass, error_m, error_deg, p.fit, p.score);
      const auto& c = p.evidence.constraint;
      std::printf(" %.4g %.4g %.4g %.4g", p.evidence.distinct_wall_m, c.all_m, c.open_direction_m, c.turning_m3);
      for (const WallKinds& k : {p.kinds.forward, p.kinds.backward}) {
        std::printf(" %.4g %.4g %.4g %.4g %.4g %.4g %.4g %.4g", k.wall_m, k.tight_m, k.loose_m, k.clutter_m,
                  k.contradicted_m, k.hidden_m, k.unexplained_m, k.outside_m);
      }
      std::printf("\n");
    }
    ++pass;
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
            visit_building(c, s, scanner, stranger ? 4 : 8, stranger,
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
