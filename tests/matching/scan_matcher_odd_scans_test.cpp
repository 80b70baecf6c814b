// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Scans as broken sensors give them: any outcome, but an outcome.
#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Eigenvalues>
#include <limits>

#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/matching/trace.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::scan_matcher_odd_scans_test {

using testing::Fan;
using testing::scan_of_walls;
using testing::uniform;

const Fan kFullTurn{360, rad_from_deg(-180), rad_from_deg(1)};

/// What every result promises, whatever the scans.
void expect_sound(const MatchResult& result) {
  if (result.T_reference_current) {
    EXPECT_TRUE(result.T_reference_current->translation().allFinite());
    EXPECT_GE(result.T_reference_current->theta_rad, -kPi);
    EXPECT_LT(result.T_reference_current->theta_rad, kPi);
    EXPECT_LE(std::abs(result.zncc_x), 1.0);
    EXPECT_LE(std::abs(result.zncc_y), 1.0);
  } else {
    EXPECT_TRUE(result.status == MatchStatus::kTooFewPoints ||
                result.status == MatchStatus::kNoOverlap);
  }
  EXPECT_TRUE(std::isfinite(result.score));
  EXPECT_LE(result.score, 1.0);
  for (const double share : {result.agreement, result.contradiction, result.overlap}) {
    EXPECT_GE(share, 0.0);
    EXPECT_LE(share, 1.0 + 1e-6);
  }
  // A degenerate answer may lack the direction: where the rotation is what is open.
  EXPECT_TRUE(result.status == MatchStatus::kDegenerate || !result.degenerate_direction_rad);
  ASSERT_TRUE(result.information.allFinite());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(result.information);
  EXPECT_GE(solver.eigenvalues()(0), -1e-5 * (1.0 + solver.eigenvalues()(2)));
  EXPECT_LE((result.information - result.information.transpose()).norm(),
            1e-9 * (1.0 + result.information.norm()));
}

Scan random_garbage(std::mt19937_64& generator) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInf = std::numeric_limits<double>::infinity();
  const double odd_m[] = {kNaN, kInf, -kInf, 0.0, -3.0, 5e-324, 1e-40, 1e-7, 0.004, 81.83, 1e300};
  Scan scan;
  const std::size_t num_beams = generator() % 4 == 0 ? generator() % 13 : 20 + generator() % 1100;
  const double sense = generator() % 2 == 0 ? 1.0 : -1.0;
  scan.first_bearing_rad = uniform(generator, -7.0, 7.0);
  scan.bearing_step_rad =
      sense * uniform(generator, 1e-4, kTwoPi) / static_cast<double>(num_beams + 1);
  if (generator() % 2 == 0) scan.max_range_m = 30.0;
  const double odd_share = uniform(generator, 0.0, 0.6);
  double range_m = uniform(generator, 0.1, 15.0);
  for (std::size_t beam = 0; beam < num_beams; ++beam) {
    if (uniform(generator, 0.0, 1.0) < 0.05) range_m = uniform(generator, 0.001, 40.0);
    const bool is_odd = uniform(generator, 0.0, 1.0) < odd_share;
    scan.ranges_m.push_back(is_odd ? odd_m[generator() % std::size(odd_m)] : range_m);
  }
  return scan;
}

TEST(OddScans, AnyRangesAndGeometriesHaveAnOutcome) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 300; ++trial) {
    SCOPED_TRACE(trial);
    expect_sound(match(random_garbage(generator), random_garbage(generator)));
    if (HasFatalFailure()) return;
  }
}

TEST(OddScans, AnyRangesAgainstARoomHaveAnOutcome) {
  auto generator = testing::make_generator();
  const Scan room = scan_of_walls(testing::l_shaped_room(), {2, 2.5, 0.1}, kFullTurn);
  for (int trial = 0; trial < 100; ++trial) {
    SCOPED_TRACE(trial);
    const Scan garbage = random_garbage(generator);
    expect_sound(match(room, garbage));
    expect_sound(match(garbage, room));
    if (HasFatalFailure()) return;
  }
}

TEST(OddScans, NoBeamsOneBeamAndNoReturnsAreTooFewPoints) {
  const Scan room = scan_of_walls(testing::l_shaped_room(), {2, 2.5, 0.1}, kFullTurn);
  Scan one = room;
  one.ranges_m = {2.0};
  one.bearing_step_rad = 0.0;
  Scan none = room;
  none.ranges_m.clear();
  Scan no_returns = room;
  no_returns.ranges_m.assign(360, 81.83);
  Scan nan = room;
  nan.ranges_m.assign(360, std::numeric_limits<double>::quiet_NaN());
  for (const Scan& poor : {one, none, no_returns, nan}) {
    for (const MatchResult& result : {match(poor, room), match(room, poor), match(poor, poor)}) {
      EXPECT_EQ(result.status, MatchStatus::kTooFewPoints);
      expect_sound(result);
    }
  }
}

TEST(OddScans, ReturnsOnTheSensorItselfSpoilNothing) {
  const Pose2 T_world_reference{2, 2.5, 0.1};
  const Pose2 T_world_current{2.5, 2.2, 0.4};
  Scan reference = scan_of_walls(testing::l_shaped_room(), T_world_reference, kFullTurn, 0.005, 1);
  Scan current = scan_of_walls(testing::l_shaped_room(), T_world_current, kFullTurn, 0.005, 2);
  for (const double range_m : {1e-60, 1e-30, 0.001, 0.009}) {
    for (std::size_t beam = 0; beam < 360; beam += 12) {
      reference.ranges_m[beam] = range_m;
      current.ranges_m[beam] = range_m;
    }
    const MatchResult result = match(reference, current);
    expect_sound(result);
    EXPECT_EQ(result.status, MatchStatus::kMatched);
    EXPECT_THAT(*result.T_reference_current,
                testing::PoseNear(T_world_reference.inverse() * T_world_current,
                                  testing::PoseTolerance{.translation_m = 0.03,
                                                         .rotation_rad = rad_from_deg(0.5)}));
  }
}

TEST(OddScans, APointMovedOntoTheOtherSensorIsLookedUp) {
  const Scan scan = scan_of_walls(testing::empty_rectangle(6, 4), {2, 2, 0}, kFullTurn);
  const PreparedScan room = prepare(scan);
  SurfaceSamples sample;
  sample.x_m = {2.0F, 0, 0, 0};
  sample.y_m = {1.0F, 0, 0, 0};
  sample.normal_x = sample.normal_y = {0, 0, 0, 0};
  sample.weight_m = {0.1F, 0, 0, 0};
  sample.count = 1;
  const Alignment result = align_one_way(room.image(), sample, {-2.0, -1.0, 0.0}, 0.2);
  EXPECT_TRUE(result.hessian.allFinite());
  // Where the sensor stands is free.
  EXPECT_FLOAT_EQ(static_cast<float>(result.evidence.contradicted_m), 0.1F);
}

TEST(OddScans, CoarseAndFineSensorsMatchEachOther) {
  const Pose2 T_world_reference{2, 2.5, 0.1};
  const Pose2 T_world_current{2.6, 2.1, -0.6};
  const Fan fans[] = {{61, rad_from_deg(-150), rad_from_deg(5)},
                      {181, rad_from_deg(-90), rad_from_deg(1)},
                      {1081, rad_from_deg(135), rad_from_deg(-0.25)},
                      {4000, rad_from_deg(-180), rad_from_deg(0.09)}};
  for (const Fan& a : fans) {
    for (const Fan& b : fans) {
      SCOPED_TRACE(::testing::Message() << a.num_beams << " and " << b.num_beams << " beams");
      const MatchResult result =
          match(scan_of_walls(testing::l_shaped_room(), T_world_reference, a, 0.003, 1),
                scan_of_walls(testing::l_shaped_room(), T_world_current, b, 0.003, 2));
      expect_sound(result);
      ASSERT_TRUE(result.T_reference_current.has_value());
      EXPECT_THAT(*result.T_reference_current,
                  testing::PoseNear(T_world_reference.inverse() * T_world_current,
                                    testing::PoseTolerance{.translation_m = 0.05,
                                                           .rotation_rad = rad_from_deg(1)}));
    }
  }
}

TEST(OddScans, ElevenBeamsHaveAnOutcome) {
  auto generator = testing::make_generator();
  const Fan eleven{11, rad_from_deg(-90), rad_from_deg(18)};
  for (int trial = 0; trial < 50; ++trial) {
    const auto room = testing::furnished_room(generator);
    const Pose2 a = testing::free_pose(room, generator);
    const Pose2 b = testing::free_pose(room, generator);
    const MatchResult result =
        match(scan_of_walls(room.walls, a, eleven), scan_of_walls(room.walls, b, eleven));
    expect_sound(result);
  }
}

TEST(OddScans, ATraceHoldsNothingOfTheMatchBefore) {
  const PreparedScan room =
      prepare(scan_of_walls(testing::l_shaped_room(), {2, 2.5, 0.1}, kFullTurn));
  MatchTrace trace;
  ASSERT_EQ(match(room, room, {}, &trace).status, MatchStatus::kMatched);
  EXPECT_FALSE(trace.candidates.empty());
  ASSERT_EQ(match(room, prepare(Scan{}), {}, &trace).status, MatchStatus::kTooFewPoints);
  EXPECT_TRUE(trace.candidates.empty());
  EXPECT_TRUE(trace.rotations.empty());
}

}  // namespace setsquare::scan_matcher_odd_scans_test
