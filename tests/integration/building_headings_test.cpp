// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Headings in simulated buildings, tracked and fused without odometry and without closing a loop,
// against the truth. Run with --gtest_also_run_disabled_tests it gives the figures of
// docs/method.md: ten buildings of each class.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/headings/fusion.hpp"
#include "setsquare/headings/proposals.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/sensing/ray_casting.hpp"
#include "setsquare/sim/sensing/robot_path.hpp"
#include "setsquare/sim/sensing/scanner_model.hpp"
#include "setsquare/sim/sensing/simulated_scan.hpp"
#include "setsquare/tracking/motion_uncertainty.hpp"
#include "setsquare/tracking/scan_tracker.hpp"

namespace setsquare::building_headings_test {

struct SeededBuilding {
  BuildingClass building_class = BuildingClass::kWings;
  std::uint64_t seed = 1;
  double max_mean_deg = 0.0;
};

/// The evidence of tracking and walls at the keyframes of a drive, and the true headings.
struct Drive {
  std::vector<HeadingEvidence> evidence;
  std::vector<double> heading_rad;
};

Drive drive_through(const SeededBuilding& seeded) {
  const Building building = make_building(seeded.building_class, seeded.seed);
  const RobotPath path(building.route_m);
  const RayCaster caster(building.plan);
  const ScannerModel scanner = utm_30lx();
  ScanTracker tracker;
  MotionUncertainty uncertainty{MotionUncertaintyParams{}};
  Drive drive;
  const auto num_scans = static_cast<std::size_t>(path.duration_s() * 10.0);
  for (std::size_t i = 0; i < num_scans; ++i) {
    Random random(sub_seed(seeded.seed, i));
    const SimulatedScan simulated =
        simulate_scan(caster, building.people, scanner, path, 0.1 * static_cast<double>(i), random);
    const TrackedPose tracked = tracker.track(simulated.scan, std::nullopt);
    uncertainty.add(tracked, {0, simulated.scan.stamp});
    if (!tracked.is_keyframe) continue;
    drive.heading_rad.push_back(simulated.T_map_base.theta_rad);
    drive.evidence.push_back({.tracked_heading_rad = tracked.T_odom_sensor.theta_rad,
                              .step_sigma_rad = std::sqrt(uncertainty.take().rotation_rad2),
                              .proposals = {}});
    drive.evidence.back().proposals =
        heading_proposals(simulated.scan, {}, MapperParams{}.confident_margin);
  }
  return drive;
}

/// Mean distance of headings from the truth, apart from what all have in common.
double mean_error_rad(const std::vector<double>& heading_rad,
                      const std::vector<double>& truth_rad) {
  std::vector<double> errors_rad;
  for (std::size_t k = 0; k < heading_rad.size(); ++k) {
    errors_rad.push_back(wrap_to_pi(heading_rad[k] - truth_rad[k] - heading_rad[0] + truth_rad[0]));
  }
  std::vector<double> sorted_rad = errors_rad;
  std::sort(sorted_rad.begin(), sorted_rad.end());
  double sum_rad = 0.0;
  for (const double error_rad : errors_rad) {
    sum_rad += std::abs(error_rad - sorted_rad[sorted_rad.size() / 2]);
  }
  return sum_rad / static_cast<double>(errors_rad.size());
}

class BuildingHeadings : public ::testing::TestWithParam<SeededBuilding> {};

TEST_P(BuildingHeadings, StayNearTheTruth) {
  const Drive drive = drive_through(GetParam());
  const FusedHeadings fused = fuse_headings(drive.evidence);
  const double mean_deg = deg_from_rad(mean_error_rad(fused.heading_rad, drive.heading_rad));
  std::cout << to_string(GetParam().building_class) << ' ' << GetParam().seed << ": " << mean_deg
            << " deg, frames:";
  for (const HeadingFrame& frame : fused.frames) {
    std::cout << ' ' << deg_from_rad(frame.offset_rad) << " deg";
  }
  std::cout << '\n';
  EXPECT_LE(mean_deg, GetParam().max_mean_deg);
  if (GetParam().building_class == BuildingClass::kWings) {
    EXPECT_EQ(fused.frames.size(), 2U);
  }
}

std::string test_name(const ::testing::TestParamInfo<SeededBuilding>& info) {
  return std::string(to_string(info.param.building_class)) + std::to_string(info.param.seed);
}

INSTANTIATE_TEST_SUITE_P(AFew,
                         BuildingHeadings,
                         ::testing::Values(SeededBuilding{BuildingClass::kWings, 1, 0.3},
                                           SeededBuilding{BuildingClass::kWings, 3, 0.3},
                                           SeededBuilding{BuildingClass::kOffice, 4, 0.3},
                                           SeededBuilding{BuildingClass::kRound, 4, 1.0}),
                         test_name);

std::vector<SeededBuilding> ten_of_each_class() {
  std::vector<SeededBuilding> buildings;
  for (const BuildingClass building_class : {BuildingClass::kWings,
                                             BuildingClass::kOffice,
                                             BuildingClass::kHall,
                                             BuildingClass::kCorridor,
                                             BuildingClass::kRound}) {
    const double max_deg = building_class == BuildingClass::kRound ? 1.0 : 0.3;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      buildings.push_back({building_class, seed, max_deg});
    }
  }
  return buildings;
}

INSTANTIATE_TEST_SUITE_P(DISABLED_TenOfEachClass,
                         BuildingHeadings,
                         ::testing::ValuesIn(ten_of_each_class()),
                         test_name);

}  // namespace setsquare::building_headings_test
