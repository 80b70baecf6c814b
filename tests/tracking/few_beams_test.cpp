// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// For the kind of scanner that sees little: sixteen beams hit a corner here and a wall there, and
// are pulled aside in the submap. That the headings are off is not mended by jolts, but told.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "setsquare/core/angle.hpp"
#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/sensing/ray_casting.hpp"
#include "setsquare/sim/sensing/robot_path.hpp"
#include "setsquare/sim/sensing/scanner_model.hpp"
#include "setsquare/sim/sensing/simulated_scan.hpp"
#include "setsquare/tracking/scan_tracker.hpp"

namespace setsquare::few_beams_test {

/// Scans along a way through a building whose heading is off by more than 5 deg, and how many of
/// these by more than three times what the jolts before add up to.
struct Turned {
  std::size_t num = 0;
  std::size_t num_silent = 0;
};

Turned turned_scans(std::uint64_t seed, const ScanTrackerParams& params) {
  constexpr double kPeriod_s = 0.2;
  const Building building = make_building(BuildingClass::kOffice, seed);
  const RobotPath path(building.route_m);
  const RayCaster caster(building.plan);
  const ScannerModel scanner = with_num_beams(low_cost_360(), 16);
  ScanTracker tracker(params);
  Turned turned;
  double variance_rad2 = 0.0;
  std::optional<Pose2> T_map_first;
  const auto num_scans = static_cast<std::size_t>(path.duration_s() / kPeriod_s);
  for (std::size_t i = 0; i < num_scans; ++i) {
    Random random(sub_seed(seed, i));
    const SimulatedScan simulated = simulate_scan(
        caster, building.people, scanner, path, kPeriod_s * static_cast<double>(i), random);
    const Pose2 T_map_sensor = simulated.T_map_base * simulated.scan.T_base_sensor;
    if (!T_map_first) T_map_first = T_map_sensor;
    const TrackedPose tracked = tracker.track(simulated.scan, std::nullopt);
    if (tracked.is_restart) break;  // From here on it is another piece of track.
    variance_rad2 += tracked.departure.turn_rad * tracked.departure.turn_rad;
    const Pose2 T_first_sensor = T_map_first->inverse() * T_map_sensor;
    const double off_rad =
        std::abs(wrap_to_pi(tracked.T_odom_sensor.theta_rad - T_first_sensor.theta_rad));
    if (!(off_rad > rad_from_deg(5.0))) continue;
    ++turned.num;
    turned.num_silent += off_rad > 3.0 * std::sqrt(variance_rad2);
  }
  return turned;
}

TEST(FewBeams, ScansThatArePulledAsideDepartFromTheRobotsWay) {
  ScanTrackerParams without;
  without.jolts.min_m = without.jolts.min_rad = 1e3;
  Turned all;
  for (const std::uint64_t seed : {81, 82, 83, 84}) {
    const Turned turned = turned_scans(seed, {});
    all.num += turned.num;
    all.num_silent += turned.num_silent;
    const Turned unasked = turned_scans(seed, without);
    EXPECT_GT(unasked.num_silent, 50U) << "without the rule, seed " << seed;
  }
  EXPECT_GT(all.num, 100U);
  EXPECT_LT(all.num_silent, all.num / 20) << "of " << all.num;
}

}  // namespace setsquare::few_beams_test
