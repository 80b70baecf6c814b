// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A robot with a scanner in front and one behind in simulated buildings: the map of both against
// that of the front one alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/eval/evaluate.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/sensing/ray_casting.hpp"
#include "setsquare/sim/sensing/robot_path.hpp"
#include "setsquare/sim/sensing/scanner_model.hpp"
#include "setsquare/sim/sensing/simulated_scan.hpp"

namespace setsquare::building_scanners_test {

struct SeededBuilding {
  BuildingClass building_class = BuildingClass::kHall;
  std::uint64_t seed = 1;
};

constexpr std::size_t kNumBeams = 271;
constexpr double kEvery_m = 0.1;
constexpr double kEvery_rad = rad_from_deg(4.0);
const std::vector<Pose2> kFrontAndRear = {{0.25, 0.2, rad_from_deg(45.0)},
                                          {-0.25, -0.2, rad_from_deg(-135.0)}};

/// The scans of both, the rear one's a sweep later, in the order of time.
std::vector<SimulatedScan> scans_of_both(const SeededBuilding& seeded) {
  const Building building = make_building(seeded.building_class, seeded.seed);
  const RobotPath path(building.route_m);
  const RayCaster caster(building.plan);
  const ScannerModel scanner = with_num_beams(utm_30lx(), kNumBeams);
  std::vector<SimulatedScan> scans;
  for (const double time_s : sample_times(path, kEvery_m, kEvery_rad)) {
    for (std::size_t i = 0; i < kFrontAndRear.size(); ++i) {
      Random random(sub_seed(seeded.seed, 1000 + scans.size()));
      const double stamp_s =
          std::round(1e6 * (time_s + static_cast<double>(i) * scanner.sweep_s)) / 1e6;
      scans.push_back(
          simulate_scan(caster, building.people, scanner, path, stamp_s, random, kFrontAndRear[i]));
      scans.back().scan.scanner = static_cast<std::uint32_t>(i);
    }
  }
  return scans;
}

/// Root mean square distance of the robot's poses from the truth, of a map of the first scanners.
double error_m(const std::vector<SimulatedScan>& scans, std::uint32_t num_scanners) {
  Mapper mapper;
  Trajectory truth;
  for (const SimulatedScan& simulated : scans) {
    truth.push_back({simulated.scan.stamp, simulated.T_map_base});
    if (simulated.scan.scanner < num_scanners) mapper.add(simulated.scan);
  }
  return evaluate(trajectory_of(mapper.finish()), truth).translation_m.rmse;
}

/// In these the walls are hard to see or off square: where their directions counted once for each
/// scanner, the second one did harm.
TEST(BuildingScanners, ASecondOneHelps) {
  double sum = 0.0;
  const std::vector<SeededBuilding> buildings = {{BuildingClass::kHall, 1},
                                                 {BuildingClass::kHall, 2},
                                                 {BuildingClass::kWings, 4},
                                                 {BuildingClass::kWings, 6},
                                                 {BuildingClass::kOffice, 4},
                                                 {BuildingClass::kOffice, 6}};
  for (const SeededBuilding& seeded : buildings) {
    const std::vector<SimulatedScan> scans = scans_of_both(seeded);
    const double front_m = error_m(scans, 1);
    const double both_m = error_m(scans, 2);
    std::cout << to_string(seeded.building_class) << ' ' << seeded.seed << ": " << front_m
              << " m in front, " << both_m << " m with both\n";
    sum += both_m / front_m;
  }
  EXPECT_LT(sum / static_cast<double>(buildings.size()), 0.95);
}

}  // namespace setsquare::building_scanners_test
