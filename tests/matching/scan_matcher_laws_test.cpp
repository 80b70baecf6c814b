// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What must hold of any match, whatever the room and the sensor.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <Eigen/Eigenvalues>

#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::scan_matcher_laws_test {

using testing::Fan;
using testing::PoseNear;
using testing::PoseTolerance;

const Fan kHalfTurn{361, rad_from_deg(-90), rad_from_deg(0.5)};
const Fan kFullTurn{360, rad_from_deg(-180), rad_from_deg(1)};
const Fan kClockwise{720, rad_from_deg(180), rad_from_deg(-0.5)};
const Fan kHokuyo{1081, rad_from_deg(-135), rad_from_deg(0.25)};

/// A room that looks like itself from nowhere else, two poses in it and the sensors there.
struct Place {
  const char* name;
  std::vector<testing::Wall> walls;
  Pose2 T_world_reference;
  Pose2 T_world_current;
  Fan reference_fan;
  Fan current_fan;

  [[nodiscard]] Scan reference() const {
    return testing::scan_of_walls(walls, T_world_reference, reference_fan, 0.005, 11);
  }
  [[nodiscard]] Scan current() const {
    return testing::scan_of_walls(walls, T_world_current, current_fan, 0.005, 12);
  }
  [[nodiscard]] Pose2 truth() const { return T_world_reference.inverse() * T_world_current; }
};

void PrintTo(const Place& place, std::ostream* out) { *out << place.name; }

/// Three walls alone fit many a corner (a bare triangle is tried in scan_matcher_honesty_test), so
/// two boxes stand in it.
std::vector<testing::Wall> triangular_room() {
  auto walls = testing::closed_polygon({{-3, -2}, {4, -1}, {0.5, 5}});
  for (const auto& box : {testing::closed_polygon({{1.8, -1}, {2.6, -0.8}, {2.4, 0}, {1.6, -0.2}}),
                          testing::closed_polygon({{-1.9, -1}, {-1, -1.4}, {-0.7, -0.7}})}) {
    walls.insert(walls.end(), box.begin(), box.end());
  }
  return walls;
}

std::vector<Place> places() {
  const auto l_shaped = testing::l_shaped_room();
  return {
      {"l_shaped", l_shaped, {2, 2.5, 0.3}, {2.9, 2.1, 0.5}, kHalfTurn, kHalfTurn},
      {"l_shaped_other_heading", l_shaped, {2, 2.5, 0.3}, {3.0, 2, -2.4}, kFullTurn, kFullTurn},
      {"l_shaped_other_sensor", l_shaped, {2, 2.5, 1.0}, {1.6, 4, 0.4}, kHokuyo, kClockwise},
      {"triangular", triangular_room(), {0.5, 0.5, 0.2}, {0, 1.2, 1.9}, kFullTurn, kClockwise},
      {"oblique", testing::oblique_room(), {2, 1.2, 0.4}, {3.4, 1.5, -0.3}, kHokuyo, kHokuyo},
      {"irregular", testing::irregular_room(), {2.5, 3, 0}, {3, 2.1, 2.8}, kFullTurn, kHokuyo},
  };
}

class Match : public ::testing::TestWithParam<Place> {};

TEST_P(Match, FindsTheTruth) {
  const MatchResult result = match(GetParam().reference(), GetParam().current());
  EXPECT_EQ(result.status, MatchStatus::kMatched);
  ASSERT_TRUE(result.T_reference_current.has_value());
  EXPECT_THAT(*result.T_reference_current,
              PoseNear(GetParam().truth(),
                       PoseTolerance{.translation_m = 0.02, .rotation_rad = rad_from_deg(0.3)}));
}

TEST_P(Match, OfAScanWithItselfIsIdentity) {
  for (const Scan& scan : {GetParam().reference(), GetParam().current()}) {
    const MatchResult result = match(scan, scan);
    EXPECT_EQ(result.status, MatchStatus::kMatched);
    ASSERT_TRUE(result.T_reference_current.has_value());
    EXPECT_THAT(*result.T_reference_current,
                PoseNear(Pose2{}, PoseTolerance{.translation_m = 1e-3, .rotation_rad = 1e-3}));
    EXPECT_GT(result.score, 0.9);
    EXPECT_LT(result.contradiction, 0.01);
    EXPECT_DOUBLE_EQ(result.zncc_x, 1.0);
    EXPECT_DOUBLE_EQ(result.zncc_y, 1.0);
  }
}

TEST_P(Match, TheOtherWayRoundIsTheInverse) {
  const MatchResult forth = match(GetParam().reference(), GetParam().current());
  const MatchResult back = match(GetParam().current(), GetParam().reference());
  EXPECT_EQ(forth.status, back.status);
  EXPECT_THAT(back.T_reference_current->inverse(),
              PoseNear(*forth.T_reference_current,
                       PoseTolerance{.translation_m = 0.005, .rotation_rad = 0.002}));
  EXPECT_NEAR(forth.score, back.score, 0.02);
}

TEST_P(Match, TurningTheSensorsOnTheirMountsConjugatesTheAnswer) {
  const MatchResult before = match(GetParam().reference(), GetParam().current());
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 12; ++trial) {
    const Pose2 turn_reference{0, 0, testing::uniform(generator, -kPi, kPi)};
    const Pose2 turn_current{0, 0, testing::uniform(generator, -kPi, kPi)};
    Scan reference = GetParam().reference();
    Scan current = GetParam().current();
    reference.first_bearing_rad += turn_reference.theta_rad;
    current.first_bearing_rad += turn_current.theta_rad;
    const MatchResult after = match(reference, current);
    EXPECT_EQ(after.status, before.status);
    EXPECT_THAT(*after.T_reference_current,
                PoseNear(turn_reference * *before.T_reference_current * turn_current.inverse(),
                         PoseTolerance{.translation_m = 0.01, .rotation_rad = 0.003}));
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    R.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(turn_reference.theta_rad).toRotationMatrix();
    EXPECT_LT((after.information - R * before.information * R.transpose()).norm(),
              0.1 * before.information.norm());
  }
}

TEST_P(Match, DoesNotDependOnTheBeamsOrder) {
  const auto reversed = [](Scan scan) {
    scan.first_bearing_rad = scan.bearing_rad(scan.num_beams() - 1);
    scan.bearing_step_rad = -scan.bearing_step_rad;
    std::reverse(scan.ranges_m.begin(), scan.ranges_m.end());
    return scan;
  };
  const MatchResult before = match(GetParam().reference(), GetParam().current());
  const MatchResult after = match(reversed(GetParam().reference()), reversed(GetParam().current()));
  EXPECT_EQ(after.status, before.status);
  EXPECT_THAT(*after.T_reference_current,
              PoseNear(*before.T_reference_current,
                       PoseTolerance{.translation_m = 0.003, .rotation_rad = 0.001}));
}

TEST_P(Match, RepeatingEveryBeamChangesLittle) {
  const auto doubled = [](const Scan& scan) {
    Scan twice = scan;
    twice.bearing_step_rad = 0.5 * scan.bearing_step_rad;
    twice.first_bearing_rad -= 0.25 * scan.bearing_step_rad;
    twice.ranges_m.clear();
    for (const double range_m : scan.ranges_m)
      twice.ranges_m.insert(twice.ranges_m.end(), 2, range_m);
    return twice;
  };
  const MatchResult before = match(GetParam().reference(), GetParam().current());
  const MatchResult after = match(doubled(GetParam().reference()), doubled(GetParam().current()));
  EXPECT_EQ(after.status, before.status);
  EXPECT_THAT(*after.T_reference_current,
              PoseNear(*before.T_reference_current,
                       PoseTolerance{.translation_m = 0.015, .rotation_rad = 0.004}));
}

TEST_P(Match, UsesNoStampAndNoMounting) {
  Scan reference = GetParam().reference();
  Scan current = GetParam().current();
  const MatchResult before = match(reference, current);
  reference.stamp = Timestamp{5'000'000'000};
  current.stamp = Timestamp{-7};
  reference.T_base_sensor = {3.0, 2.0, 1.0};
  EXPECT_EQ(match(reference, current).T_reference_current, before.T_reference_current);
}

TEST_P(Match, IsTheSameToTheLastBitTwice) {
  const auto bytes = [](const MatchResult& result) {
    std::vector<double> values(result.information.data(), result.information.data() + 9);
    values.insert(values.end(),
                  {result.T_reference_current->x_m,
                   result.T_reference_current->y_m,
                   result.T_reference_current->theta_rad,
                   result.score,
                   result.agreement,
                   result.contradiction,
                   result.overlap,
                   result.zncc_x,
                   result.zncc_y,
                   result.runner_up ? result.runner_up->score : 0.0});
    return values;
  };
  const auto once = bytes(match(GetParam().reference(), GetParam().current()));
  const auto again = bytes(match(prepare(GetParam().reference()), prepare(GetParam().current())));
  EXPECT_EQ(std::memcmp(once.data(), again.data(), once.size() * sizeof(double)), 0);
}

TEST_P(Match, EvidenceStaysWithinItsBounds) {
  for (const auto& [a, b] : {std::pair{GetParam().reference(), GetParam().current()},
                             std::pair{GetParam().current(), GetParam().reference()}}) {
    const MatchResult result = match(a, b);
    EXPECT_LE(result.score, 1.0);
    EXPECT_LE(std::abs(result.zncc_x), 1.0);
    EXPECT_LE(std::abs(result.zncc_y), 1.0);
    for (const double share : {result.agreement, result.contradiction, result.overlap}) {
      EXPECT_GE(share, 0.0);
      EXPECT_LE(share, 1.0 + 1e-6);
    }
    if (result.runner_up) {
      EXPECT_LE(result.runner_up->score, result.score);
    }
    const Eigen::Matrix3d& information = result.information;
    EXPECT_LT((information - information.transpose()).norm(), 1e-9 * information.norm());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(information);
    EXPECT_GT(solver.eigenvalues()(0), 0.0);  // These places determine the pose.
  }
}

INSTANTIATE_TEST_SUITE_P(Places, Match, ::testing::ValuesIn(places()), [](const auto& tested) {
  return std::string(tested.param.name);
});

}  // namespace setsquare::scan_matcher_laws_test
