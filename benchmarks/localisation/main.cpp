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
#include "setsquare/io/logs/open_log.hpp"
#include "setsquare/io/maps/map_pgm_yaml.hpp"
#include "setsquare/localisation/localizer.hpp"
#include "setsquare/localisation/place_probability.hpp"
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
      std::printf("P %d %d %.3f %.2f %.3f", id, pass, error_m, error_deg, p.known_share);
      for (const double f : place_features(p)) std::printf(" %.6g", f);
      std::printf("\n");
    }
  }
}

/// Starts anew every `every_m` of the second half of a log, and follows each start for `way_m`.
void run_follow(const std::string& log_path, double every_m, double way_m) {
  const MappedHalf half = mapped_half(log_path);
  Eigen::Vector2d last(1e9, 1e9);
  std::size_t starts = 0, right_end = 0, wrong_end = 0, ever_wrong = 0, wrong_scans = 0, scans = 0, loc_scans = 0;
  std::vector<double> to_localised_m, errors_m, errors_deg;
  double worst_sigmas = 0.0;
  std::size_t beyond = 0;
  for (std::size_t start = half.scans.size() / 2; start < half.scans.size(); ++start) {
    if (!half.T_map_sensor[start]) continue;
    const Pose2& T0 = *half.T_map_sensor[start];
    if ((T0.translation() - last).norm() < every_m) continue;
    if (overlap_with_map(*half.map, half.scans[start], T0) < 0.45) continue;
    // The way ahead overlaps, too.
    std::size_t end = start;
    double way = 0.0;
    bool overlaps = true;
    while (way < way_m && overlaps && end + 1 < half.scans.size() && half.T_map_sensor[end + 1]) {
      way += (half.T_map_sensor[end + 1]->translation() - half.T_map_sensor[end]->translation()).norm();
      ++end;
      if (end % 10 == 0) overlaps = overlap_with_map(*half.map, half.scans[end], *half.T_map_sensor[end]) > 0.45;
    }
    if (way < way_m || !overlaps) continue;
    last = T0.translation();
    ++starts;
    Localizer localizer(half.map);
    LocalisedPose pose;
    double driven = 0.0;
    bool is_localised = false, was_wrong = false, is_wrong = false;
    for (std::size_t i = start; i <= end; ++i) {
      pose = localizer.add(half.scans[i]);
      if (i > start) driven += (half.T_map_sensor[i]->translation() - half.T_map_sensor[i - 1]->translation()).norm();
      ++scans;
      is_wrong = false;
      if (std::getenv("D") && start == std::size_t(std::atoi(std::getenv("D"))) && i % 12 == 0) {
        const SoughtScan so = sought_scan(half.scans[i]);
        const Pose2 Tg = half.map->T_map_grid().inverse();
        for (const Pose2& T : {*half.T_map_sensor[i], pose.T_map_sensor}) {
          const VerifiedPlace v = verified_place(*half.map, so, Tg * T);
          const auto f = place_features(v);
          std::printf("%zu driven %.1f p %.3f %s: rank %.2f presence %.2f known %.2f |", i, driven, pose.probability, to_string(pose.status), place_rank(f), presence_log_odds(f), v.known_share);
          for (double x : f) std::printf(" %.2f", x);
          std::printf("\n");
        }
      }
      if (pose.status != LocalisationStatus::kLocalised) continue;
      ++loc_scans;
      if (!is_localised) to_localised_m.push_back(driven);
      is_localised = true;
      const Pose2 e = half.T_map_sensor[i]->inverse() * pose.T_map_sensor;
      is_wrong = e.translation().norm() > 0.5 || std::abs(e.theta_rad) > 0.14;
      wrong_scans += is_wrong;
      was_wrong |= is_wrong;
      if (!is_wrong) {
        errors_m.push_back(e.translation().norm());
        errors_deg.push_back(std::abs(e.theta_rad) * 57.29578);
        const double sigmas = e.translation().norm() / std::sqrt(pose.covariance.topLeftCorner<2, 2>().trace());
        worst_sigmas = std::max(worst_sigmas, sigmas);
        beyond += sigmas > 3.0;
      }
    }
    const bool at_end = pose.status == LocalisationStatus::kLocalised;
    right_end += at_end && !is_wrong;
    wrong_end += at_end && is_wrong;
    ever_wrong += was_wrong;
    if (std::getenv("V") != nullptr && (was_wrong || !at_end)) {
      const Pose2 t = half.T_map_sensor[end] ? *half.T_map_sensor[end] : Pose2{};
      std::printf("start %zu: %s at end, p %.3f, %s; alternatives %zu; at %.1f %.1f %.0f truth %.1f %.1f %.0f\n", start, to_string(pose.status), pose.probability, was_wrong ? "WRONG" : "", pose.alternatives.size(), pose.T_map_sensor.x_m, pose.T_map_sensor.y_m, pose.T_map_sensor.theta_rad * 57.3, t.x_m, t.y_m, t.theta_rad * 57.3);
    }
  }
  const auto median = [](std::vector<double> v) {
    if (v.empty()) return -1.0;
    std::sort(v.begin(), v.end());
    return v[v.size() / 2];
  };
  const auto mean = [](const std::vector<double>& v) {
    double s = 0.0;
    for (double x : v) s += x;
    return v.empty() ? -1.0 : s / static_cast<double>(v.size());
  };
  std::printf("%s: %zu starts, after %.0f m: right %.3f wrong %zu; ever wrong %zu (%zu of %zu localised scans of %zu); localised after %.2f m (median); error %.4f m %.3f deg (mean), %.4f m (median); beyond 3 sigma %.4f\n",
              log_path.c_str(), starts, way_m, double(right_end) / double(starts), wrong_end, ever_wrong, wrong_scans, loc_scans, scans,
              median(to_localised_m), mean(errors_m), mean(errors_deg), median(errors_m), double(beyond) / double(std::max<std::size_t>(1, errors_m.size())));
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
  } else if (mode == "dbg") {
    const KnownMap map(read_map_pgm_yaml(argv[2]));
    const auto reader = open_log(argv[3]);
    const Scan scan = reader->next()->scan;
    for (const auto& v : search_places(map, sought_scan(scan))) {
      std::printf("%.2f %.2f %.0f:", v.T_grid_sensor.x_m, v.T_grid_sensor.y_m, v.T_grid_sensor.theta_rad * 57.3);
      for (double f : place_features(v)) std::printf(" %.2f", f);
      std::printf(" | wall %.2f out %.2f\n", v.kinds.forward.wall_m, v.kinds.forward.outside_m);
    }
  } else if (mode == "follow") {
    run_follow(argv[2], std::atof(argv[3]), std::atof(argv[4]));
  } else if (mode == "sim") {
    const int seeds = std::atoi(argv[3]);
    for (int s = std::atoi(argv[2]); s < std::atoi(argv[2]) + seeds; ++s) {
      int group = 10;
      for (const auto c : kAllBuildingClasses) {
        for (const bool stranger : {false, true}) {
          int which = 0;
          for (const auto& scanner : {utm_30lx(), still_scanner(kPi, 181, 0.02, 30.0), low_cost_360(),
                                      still_scanner(kTwoPi, 360, 0.05, 10.0),
                                      still_scanner(1.5 * kPi, 1081, 0.05, 10.0)}) {
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
