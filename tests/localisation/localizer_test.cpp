// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/localizer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/grid/grid_from_scans.hpp"
#include "setsquare/localisation/known_map.hpp"
#include "tests/support/seed.hpp"
#include "tests/support/simulated_drive.hpp"

namespace setsquare::localizer_test {

constexpr testing::Fan kFan{541, -0.75 * kPi, rad_from_deg(0.5)};
constexpr double kNoise_m = 0.01;

std::shared_ptr<const KnownMap> map_of(const std::vector<Scan>& scans,
                                       const std::vector<Pose2>& poses) {
  std::vector<PlacedScan> placed;
  for (std::size_t i = 0; i < scans.size(); ++i) placed.push_back({&scans[i], poses[i]});
  return std::make_shared<const KnownMap>(grid_from_scans(placed));
}

/// A drive through the room, mapped at the true poses, and another way through it.
class MappedRoom : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto mapping = testing::drive(testing::way_around_the_room());
    map_ =
        map_of(testing::scans_on_drive(testing::l_shaped_room(), mapping, kNoise_m, kFan), mapping);
    poses_ = testing::drive({{4.0, 3.0}, {2.0, 2.0}, {1.5, 7.0}, {3.0, 3.0}, {6.5, 3.0}});
    scans_ = testing::scans_on_drive(testing::l_shaped_room(), poses_, kNoise_m, kFan);
  }

  std::shared_ptr<const KnownMap> map_;
  std::vector<Pose2> poses_;
  std::vector<Scan> scans_;
};

double error_m(const LocalisedPose& pose, const Pose2& truth) {
  return (pose.T_map_sensor.translation() - truth.translation()).norm();
}

TEST_F(MappedRoom, IsFoundAndFollowedFromNoStartPose) {
  Localizer localizer(map_);
  std::size_t num_localised = 0;
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    const LocalisedPose pose = localizer.add(scans_[i]);
    EXPECT_EQ(pose.stamp, scans_[i].stamp);
    if (pose.status != LocalisationStatus::kLocalised) continue;
    ++num_localised;
    EXPECT_LT(error_m(pose, poses_[i]), 0.06) << "scan " << i;
    EXPECT_LT(std::abs(wrap_to_pi(pose.T_map_sensor.theta_rad - poses_[i].theta_rad)),
              rad_from_deg(1.5))
        << "scan " << i;
    EXPECT_LT(error_m(pose, poses_[i]),
              3.0 * std::sqrt(pose.covariance.topLeftCorner<2, 2>().trace()));
  }
  EXPECT_GE(num_localised, scans_.size() * 9 / 10);
}

TEST_F(MappedRoom, GivesTheSameTwice) {
  Localizer a(map_);
  Localizer b(map_);
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_EQ(a.add(scans_[i]).T_map_sensor, b.add(scans_[i]).T_map_sensor);
  }
}

TEST_F(MappedRoom, TheMountingLiesBetweenTheSensorAndTheRobot) {
  const Pose2 T_base_sensor{0.2, -0.1, 0.5};
  Localizer localizer(map_);
  for (std::size_t i = 0; i < 30; ++i) {
    Scan scan = scans_[i];
    scan.T_base_sensor = T_base_sensor;
    const LocalisedPose pose = localizer.add(scan);
    const Pose2 expected = pose.T_map_sensor * T_base_sensor.inverse();
    EXPECT_NEAR((pose.T_map_base.translation() - expected.translation()).norm(), 0.0, 1e-9);
  }
}

TEST_F(MappedRoom, ARobotThatIsCarriedIsFoundAgain) {
  Localizer localizer(map_);
  const std::size_t half = scans_.size() / 2;
  for (std::size_t i = 0; i < half; ++i) (void)localizer.add(scans_[i]);
  // Picked up and put down at the start of the way, a minute later.
  std::size_t num_right = 0;
  std::size_t num_wrong_at_last = 0;
  for (std::size_t i = 0; i < half; ++i) {
    Scan scan = scans_[i];
    scan.stamp.ns += 60'000'000'000 + static_cast<std::int64_t>(half) * 100'000'000;
    const LocalisedPose pose = localizer.add(scan);
    const bool is_localised = pose.status == LocalisationStatus::kLocalised;
    num_right += is_localised && error_m(pose, poses_[i]) < 0.1;
    if (i > half / 2) num_wrong_at_last += is_localised && error_m(pose, poses_[i]) > 0.5;
  }
  EXPECT_GE(num_right, half / 2);
  EXPECT_EQ(num_wrong_at_last, 0U);
}

TEST_F(MappedRoom, APoseThatIsSaidTellsAlikePlacesApart) {
  // An empty rectangle looks the same after a half turn.
  const auto walls = std::vector<testing::Wall>{
      {0.0, 0.0, 8.0, 0.0}, {8.0, 0.0, 8.0, 5.0}, {8.0, 5.0, 0.0, 5.0}, {0.0, 5.0, 0.0, 0.0}};
  const auto way = testing::drive({{1.5, 1.5}, {6.0, 1.5}, {6.0, 3.5}, {2.0, 3.5}});
  const auto scans = testing::scans_on_drive(walls, way, kNoise_m, kFan);
  const auto map = map_of(scans, way);
  Localizer unsure(map);
  Localizer told(map);
  told.set_pose({way[0].x_m + 0.3, way[0].y_m - 0.2, way[0].theta_rad + 0.2});
  LocalisedPose pose;
  for (std::size_t i = 0; i < 60; ++i) {
    EXPECT_NE(unsure.add(scans[i]).status, LocalisationStatus::kLocalised) << "scan " << i;
    pose = told.add(scans[i]);
  }
  EXPECT_EQ(pose.status, LocalisationStatus::kLocalised);
  EXPECT_LT(error_m(pose, way[59]), 0.06);
}

TEST_F(MappedRoom, APoseThatIsSaidWronglyIsNotBelievedAgainstTheScans) {
  Localizer localizer(map_);
  localizer.set_pose({2.0, 7.5, 1.0});  // In the other wing.
  for (std::size_t i = 0; i < scans_.size() / 2; ++i) {
    const LocalisedPose pose = localizer.add(scans_[i]);
    if (pose.status != LocalisationStatus::kLocalised) continue;
    EXPECT_LT(error_m(pose, poses_[i]), 0.1) << "scan " << i;
  }
}

TEST_F(MappedRoom, ScansOfAnotherRoomAreNotLocalised) {
  const auto walls = std::vector<testing::Wall>{{0.0, 0.0, 6.0, 0.0},
                                                {6.0, 0.0, 7.5, 4.0},
                                                {7.5, 4.0, 2.0, 6.5},
                                                {2.0, 6.5, 0.0, 0.0},
                                                {3.0, 2.0, 4.0, 2.5},
                                                {4.0, 2.5, 3.2, 3.3}};
  const auto way = testing::drive({{1.5, 1.0}, {5.0, 1.5}, {5.0, 4.0}});
  const auto scans = testing::scans_on_drive(walls, way, kNoise_m, kFan);
  Localizer localizer(map_);
  std::size_t num_localised = 0;
  for (const Scan& scan : scans) {
    num_localised += localizer.add(scan).status == LocalisationStatus::kLocalised;
  }
  EXPECT_EQ(num_localised, 0U);
}

TEST_F(MappedRoom, BlindScansLoseNothing) {
  Localizer localizer(map_);
  for (std::size_t i = 0; i < 60; ++i) (void)localizer.add(scans_[i]);
  Scan blind = scans_[60];
  for (double& range_m : blind.ranges_m) range_m = std::nan("");
  EXPECT_NO_THROW((void)localizer.add(blind));
  const LocalisedPose pose = localizer.add(scans_[61]);
  EXPECT_LT(error_m(pose, poses_[61]), 0.2);
}

TEST_F(MappedRoom, RefusesWhatIsNoScanOrNoPose) {
  EXPECT_THROW(Localizer(nullptr), ParameterError);
  LocalisationParams params;
  params.min_probability = 1.5;
  EXPECT_THROW(Localizer(map_, params), ParameterError);
  params = {};
  params.min_probability_at_once = -0.1;
  EXPECT_THROW(Localizer(map_, params), ParameterError);
  Localizer localizer(map_);
  EXPECT_THROW(localizer.set_pose({std::nan(""), 0.0, 0.0}), ParameterError);
  EXPECT_THROW((void)localizer.add(scans_[0], Pose2{0.0, std::nan(""), 0.0}), ParameterError);
}

// Most of what the robot sees lies beyond what the map knows: each scan fits, and none can tell
// that it is not another place of that kind, however often it is asked.
TEST(PartlyMappedRoom, ManyScansThatTheMapCannotJudgeMakeNoPlaceSure) {
  auto generator = testing::make_generator();
  const std::vector<testing::Wall> walls = testing::l_shaped_room();
  constexpr testing::Fan kAhead{221, rad_from_deg(-55.0), rad_from_deg(0.5)};
  std::vector<Scan> mapped;
  std::vector<Pose2> poses;
  for (int i = 0; i < 4; ++i) {
    poses.push_back({2.0 + 0.1 * i, 2.0, 0.0});
    mapped.push_back(testing::scan_of_walls(walls, poses.back(), kAhead, kNoise_m, generator()));
  }
  Localizer localizer(map_of(mapped, poses));
  for (int i = 0; i < 12; ++i) {
    const Pose2 truth{2.2, 2.0, i % 2 == 0 ? 0.0 : rad_from_deg(20.0)};
    const Scan scan = testing::scan_of_walls(walls, truth, kFan, kNoise_m, generator());
    const LocalisedPose pose = localizer.add(scan);
    EXPECT_EQ(pose.status, LocalisationStatus::kAmbiguous) << "scan " << i;
    EXPECT_LT(error_m(pose, truth), 0.1) << "scan " << i;
  }
}

}  // namespace setsquare::localizer_test
