// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/sensing/simulated_scan.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <thread>
#include <vector>

#include "tests/sim/plans.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::testing::simulated_scan_test {

/// Measures exactly what is there.
ScannerModel perfect_scanner() {
  ScannerModel scanner = utm_30lx();
  scanner.noise_share = scanner.resolution_m = scanner.divergence_rad = 0.0;
  scanner.dropout_share = 0.0;
  return scanner;
}

double share_of_returns(const Scan& scan, double low_m, double high_m) {
  int num_returns = 0;
  for (std::size_t k = 0; k < scan.num_beams(); ++k) {
    if (scan.outcome(k) != BeamOutcome::kReturn) continue;
    if (scan.ranges_m[k] >= low_m && scan.ranges_m[k] <= high_m) ++num_returns;
  }
  return num_returns / static_cast<double>(scan.num_beams());
}

TEST(SimulatedScanTest, APerfectScannerMeasuresTheCasts) {
  auto generator = make_generator();
  const RayCaster caster(random_plan(generator, 200, 20.0));
  const RobotPath path({{0.1, 0.2}, {3.0, 1.0}});
  Random random(1);
  ScannerModel scanner = perfect_scanner();
  scanner.sweep_s = 0.0;
  const auto [scan, T_map_base, clutter] = simulate_scan(caster, {}, scanner, path, 2.0, random);
  EXPECT_EQ(T_map_base, path.pose_at(2.0));
  EXPECT_EQ(scan.stamp.ns, 2'000'000'000);
  ASSERT_EQ(scan.num_beams(), 1081u);
  int num_grazing = 0;
  for (std::size_t k = 0; k < scan.num_beams(); ++k) {
    const auto hit = caster.cast(
        T_map_base.translation(), unit_vector(T_map_base.theta_rad + scan.bearing_rad(k)), 30.0);
    if (!hit) {
      EXPECT_EQ(scan.outcome(k), BeamOutcome::kNoReturn);
    } else if (hit->incidence_cos < 0.08) {
      ++num_grazing;  // May be lost.
    } else {
      EXPECT_NEAR(scan.ranges_m[k], hit->range_m, 1e-9);
    }
  }
  EXPECT_LT(num_grazing, 200);
}

TEST(SimulatedScanTest, NoiseIsThatOfTheModel) {
  ScannerModel scanner = utm_30lx();
  const RobotPath path({{0.0, 0.0}});
  Random random(test_seed());
  // In the middle of a round hall every beam has the same range and meets the wall at right angles.
  for (const double radius_m : {0.5, 5.0, 20.0}) {
    const RayCaster caster(polygon_plan(3000, radius_m));
    double sum_m = 0.0;
    double squares_m2 = 0.0;
    int num_returns = 0;
    int num_beams = 0;
    for (int repeat = 0; repeat < 40; ++repeat) {
      const Scan scan = simulate_scan(caster, {}, scanner, path, 0.0, random).scan;
      for (std::size_t k = 0; k < scan.num_beams(); ++k, ++num_beams) {
        if (scan.outcome(k) != BeamOutcome::kReturn) continue;
        const double error_m = scan.ranges_m[k] - radius_m;
        sum_m += error_m;
        squares_m2 += error_m * error_m;
        ++num_returns;
        const double steps = scan.ranges_m[k] / scanner.resolution_m;
        ASSERT_NEAR(steps, std::round(steps), 1e-6);
      }
    }
    // Five times the statistics' own spread: 43 000 beams.
    const double sigma_m = range_noise_m(scanner, radius_m);
    EXPECT_NEAR(sum_m / num_returns, 0.0, 5.0 * sigma_m / std::sqrt(num_returns) + 2e-5);
    EXPECT_NEAR(std::sqrt(squares_m2 / num_returns), sigma_m, 0.02 * sigma_m);
    EXPECT_NEAR(1.0 - num_returns / static_cast<double>(num_beams), 0.002, 0.0011);
  }
}

TEST(SimulatedScanTest, AMovingRobotsScanIsSkewed) {
  const RayCaster caster(rectangle_plan(20.0, 20.0));
  ScannerModel scanner = perfect_scanner();
  scanner.sweep_s = 0.5;
  const RobotPath path({{5.0, 10.0}, {15.0, 10.0}}, {.drive_m_per_s = 2.0});
  Random random(1);
  const auto [scan, T_map_base, clutter] = simulate_scan(caster, {}, scanner, path, 1.0, random);
  EXPECT_THAT(T_map_base, PoseNear(Pose2{5.0 + 2.5, 10.0, 0.0}, PoseTolerance{}));
  for (std::size_t k = 0; k < scan.num_beams(); ++k) {
    const double time_s = 1.0 + 0.5 * static_cast<double>(k) / 1080.0;
    const Eigen::Vector2d from_m(5.0 + 2.0 * time_s, 10.0);
    const auto hit =
        cast_at_every_segment(caster.plan(), from_m, unit_vector(scan.bearing_rad(k)), 30);
    EXPECT_NEAR(scan.ranges_m[k], hit->range_m, 1e-9) << k;
  }
}

TEST(SimulatedScanTest, TheSameRandomStateGivesTheSameScanInAnyThread) {
  auto generator = make_generator();
  const RayCaster caster(random_plan(generator, 300, 20.0));
  const RobotPath path({{0.1, 0.2}, {3.0, 1.0}});
  const std::vector<Person> people{{{2.0, 0.0}, {0.0, 2.0}}};
  const auto simulate = [&](Scan& scan) {
    Random random(7);
    scan = simulate_scan(caster, people, low_cost_360(), path, 1.0, random).scan;
  };
  Scan alone, first, second;
  simulate(alone);
  std::thread one(simulate, std::ref(first));
  std::thread other(simulate, std::ref(second));
  one.join();
  other.join();
  EXPECT_EQ(first.ranges_m, alone.ranges_m);
  EXPECT_EQ(second.ranges_m, alone.ranges_m);
}

TEST(SimulatedScanTest, PeopleChangeOnlyTheBeamsThatMeetThem) {
  const RayCaster caster(rectangle_plan(10.0, 10.0));
  const RobotPath path({{5.0, 5.0}});
  Random random(3);
  Random same(3);
  const std::vector<Person> people{{{7.0, 5.0}, {7.0, 5.0}}};
  const auto without = simulate_scan(caster, {}, utm_30lx(), path, 0.0, random);
  const auto with = simulate_scan(caster, people, utm_30lx(), path, 0.0, same);
  int num_changed = 0;
  for (std::size_t k = 0; k < with.scan.num_beams(); ++k) {
    if (with.scan.ranges_m[k] == without.scan.ranges_m[k]) continue;
    ++num_changed;
    EXPECT_LT(std::abs(deg_from_rad(with.scan.bearing_rad(k))), 5.0);
  }
  // Two legs of 12 cm at 2 m, of which no more can be seen than 2 x 3.44 deg.
  EXPECT_NEAR(num_changed, 27, 4);
  EXPECT_EQ(without.clutter_share, 0.0);
  EXPECT_NEAR(with.clutter_share, 27.0 / 1081.0, 0.004);
}

TEST(SimulatedScanTest, ADiscIsHitWhereTheCircleIs) {
  const RobotPath path({{0.0, 0.0}});
  const Person stander{{3.0, 0.0}, {3.0, 0.0}};
  const std::vector<Disc> legs = legs_at({stander}, 0.0);
  Random random(1);
  const auto simulated =
      simulate_scan(RayCaster(FloorPlan{}), {stander}, perfect_scanner(), path, 0.0, random);
  int num_on_legs = 0;
  for (std::size_t k = 0; k < simulated.scan.num_beams(); ++k) {
    if (simulated.scan.outcome(k) != BeamOutcome::kReturn) continue;
    const Eigen::Vector2d p_m =
        simulated.scan.ranges_m[k] * unit_vector(simulated.scan.bearing_rad(k));
    EXPECT_NEAR(std::min((p_m - legs[0].center_m).norm(), (p_m - legs[1].center_m).norm()),
                legs[0].radius_m,
                1e-9);
    EXPECT_LT(p_m.x(), 3.0) << "the near side";
    ++num_on_legs;
  }
  EXPECT_GT(num_on_legs, 12);
  EXPECT_EQ(simulated.clutter_share, 1.0);
}

TEST(SimulatedScanTest, GlassIsSeenAtRightAnglesOnly) {
  FloorPlan plan;
  plan.segments.push_back({{2.0, -50.0}, {2.0, 50.0}, Material::kGlass});
  plan.segments.push_back({{2.5, -50.0}, {2.5, 50.0}, Material::kGlass});
  plan.segments.push_back({{4.0, -50.0}, {4.0, 50.0}, Material::kWall});
  const RayCaster caster(plan);
  const RobotPath path({{0.0, 0.0}});
  Random random(1);
  int num_near_normal = 0;
  int num_on_panes = 0;
  for (int repeat = 0; repeat < 20; ++repeat) {
    const Scan scan = simulate_scan(caster, {}, perfect_scanner(), path, 0.0, random).scan;
    for (std::size_t k = 0; k < scan.num_beams(); ++k) {
      const double across = std::cos(scan.bearing_rad(k));
      if (across < 0.15) continue;  // Behind, or grazing.
      const double x_m = scan.ranges_m[k] * across;
      if (across < 0.97) {
        ASSERT_NEAR(x_m, 4.0, 1e-9) << "seen through both panes";
      } else {
        ++num_near_normal;
        if (x_m < 3.0) ++num_on_panes;
      }
    }
  }
  EXPECT_NEAR(num_on_panes / static_cast<double>(num_near_normal), 0.8, 0.05);
}

TEST(SimulatedScanTest, GrazingBeamsAreLostMoreOften) {
  const RayCaster caster(corridor_plan());
  const RobotPath path({{0.0, 0.0}, {1.0, 0.0}});
  Random random(test_seed());
  int num_beams = 0;
  int num_lost = 0;
  for (int repeat = 0; repeat < 400; ++repeat) {
    const Scan scan = simulate_scan(caster, {}, perfect_scanner(), path, 0.0, random).scan;
    for (std::size_t k = 0; k < scan.num_beams(); ++k) {
      const double incidence_cos = std::abs(std::sin(scan.bearing_rad(k)));
      if (incidence_cos * 29.9 < 1.2) continue;  // Out of reach.
      if (incidence_cos > 0.08) {
        ASSERT_EQ(scan.outcome(k), BeamOutcome::kReturn);
      } else {
        ++num_beams;
        if (scan.outcome(k) != BeamOutcome::kReturn) ++num_lost;
      }
    }
  }
  // None at 0.08, a quarter of all at half of that: an eighth on average.
  EXPECT_NEAR(num_lost / static_cast<double>(num_beams), 0.125, 0.03);
}

TEST(SimulatedScanTest, RangesMixAtEdgesOnly) {
  // A screen before a wall: from 2 m to 6 m.
  FloorPlan plan;
  plan.segments.push_back({{6.0, -8.0}, {6.0, 8.0}});
  plan.segments.push_back({{2.0, -0.5}, {2.0, 0.5}});
  const RayCaster caster(plan);
  const RobotPath path({{0.0, 0.0}});
  ScannerModel scanner = perfect_scanner();
  scanner.divergence_rad = utm_30lx().divergence_rad;
  Random random(test_seed());
  int num_mixed = 0;
  constexpr int kNumScans = 200;
  for (int repeat = 0; repeat < kNumScans; ++repeat) {
    const Scan scan = simulate_scan(caster, {}, scanner, path, 0.0, random).scan;
    for (std::size_t k = 0; k < scan.num_beams(); ++k) {
      const double x_m = scan.ranges_m[k] * std::cos(scan.bearing_rad(k));
      if (std::abs(scan.bearing_rad(k)) > 0.5 || x_m < 2.05 || x_m > 5.95) continue;
      ++num_mixed;
      EXPECT_NEAR(std::abs(scan.bearing_rad(k)), std::atan(0.25), scanner.divergence_rad);
    }
  }
  // Two edges; a spot of 0.35 deg covers each with one or two beams of 0.25 deg; half of them mix.
  EXPECT_GT(num_mixed, kNumScans * 2 * 0.3);
  EXPECT_LT(num_mixed, kNumScans * 2 * 1.1);
}

TEST(SimulatedScanTest, TheBeamCountChangesButNotTheField) {
  const RayCaster caster(rectangle_plan(4.0, 4.0));
  const RobotPath path({{2.0, 2.0}});
  Random random(test_seed());
  std::size_t fewest = 1000;
  std::size_t most = 0;
  for (int repeat = 0; repeat < 100; ++repeat) {
    const Scan scan = simulate_scan(caster, {}, low_cost_360(), path, 0.0, random).scan;
    EXPECT_NO_THROW(scan.validate());
    fewest = std::min(fewest, scan.num_beams());
    most = std::max(most, scan.num_beams());
    EXPECT_NEAR(scan.bearing_step_rad * static_cast<double>(scan.num_beams()), kTwoPi, 1e-9);
    EXPECT_GT(share_of_returns(scan, 1.9, 3.0), 0.95);
  }
  EXPECT_THAT(fewest, ::testing::AllOf(::testing::Ge(352u), ::testing::Le(355u)));
  EXPECT_THAT(most, ::testing::AllOf(::testing::Ge(365u), ::testing::Le(368u)));
}

}  // namespace setsquare::testing::simulated_scan_test
