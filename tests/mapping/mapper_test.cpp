// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/mapper.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/simulated_drive.hpp"

namespace setsquare::mapper_test {

using testing::between;
using testing::drive;
using testing::l_shaped_room;
using testing::PoseNear;
using testing::PoseTolerance;
using testing::scans_on_drive;
using testing::way_around_the_room;

constexpr double kNoise_m = 0.01;
const Pose2 kMounting{0.2, -0.05, 0.1};

class MapperInRoom : public ::testing::Test {
 protected:
  MapperInRoom() : truth_(drive(way_around_the_room())) {
    scans_ = scans_on_drive(l_shaped_room(), truth_, kNoise_m);
    for (Scan& scan : scans_) scan.T_base_sensor = kMounting;
    for (const Scan& scan : scans_) mapper_.add(scan);
  }
  std::vector<Pose2> truth_;  ///< Of the sensor.
  std::vector<Scan> scans_;
  Mapper mapper_;
};

TEST_F(MapperInRoom, MapsEveryScanInOrder) {
  const Map track = mapper_.finish();
  ASSERT_EQ(track.scans.size(), scans_.size());
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    ASSERT_EQ(track.scans[i].stamp, scans_[i].stamp);
    ASSERT_THAT(between(track.scans[0].T_map_sensor, track.scans[i].T_map_sensor),
                PoseNear(between(truth_[0], truth_[i]),
                         PoseTolerance{.translation_m = 0.05, .rotation_rad = rad_from_deg(0.5)}))
        << i;
    ASSERT_THAT(track.scans[i].T_map_base * kMounting,
                PoseNear(track.scans[i].T_map_sensor, PoseTolerance{}));
  }
}

TEST_F(MapperInRoom, TheMapStandsSquare) {
  // The room's walls run along the axes of the world; so they must in the map, too.
  const Map track = mapper_.finish();
  for (std::size_t i = 0; i < truth_.size(); ++i) {
    const double error_rad =
        wrap_to_period(track.scans[i].T_map_sensor.theta_rad - truth_[i].theta_rad, 0.5 * kPi);
    ASSERT_LT(std::abs(error_rad), rad_from_deg(0.4)) << i;
  }
}

TEST_F(MapperInRoom, SameScansSameBits) {
  Mapper again;
  for (const Scan& scan : scans_) again.add(scan);
  const Map first = mapper_.finish();
  const Map second = again.finish();
  for (std::size_t i = 0; i < first.scans.size(); ++i) {
    ASSERT_EQ(first.scans[i].T_map_sensor, second.scans[i].T_map_sensor);
  }
}

TEST_F(MapperInRoom, FinishingDoesNotDisturbWhatFollows) {
  Mapper interrupted;
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    interrupted.add(scans_[i]);
    if (i == scans_.size() / 2) {
      EXPECT_EQ(interrupted.finish().scans.size(), i + 1);
    }
  }
  EXPECT_EQ(interrupted.finish().scans.back().T_map_base, mapper_.finish().scans.back().T_map_base);
}

TEST_F(MapperInRoom, TheGraphCountsHeadingsThatErrAlikeOnce) {
  const Map track = mapper_.finish();
  ASSERT_FALSE(track.graph.headings.empty());
  // A room is one place: what all keyframes tell of its walls together is about what one does.
  double sum = 0.0;
  double largest = 0.0;
  for (const HeadingMeasurement& heading : track.graph.headings) {
    const double alone = track.headings[heading.node].information_per_rad2;
    EXPECT_LE(heading.information_per_rad2, alone);
    sum += heading.information_per_rad2;
    largest = std::max(largest, alone);
  }
  EXPECT_LT(sum, 4.0 * largest);
  EXPECT_GT(sum, 0.5 * largest);
}

TEST(Mapper, NoScansNoTrack) {
  const Map track = Mapper().finish();
  EXPECT_TRUE(track.scans.empty());
  EXPECT_TRUE(track.keyframes.empty());
}

TEST(Mapper, ScansThatSeeNothingArePlacedAndCalledLost) {
  Mapper mapper;
  Scan blind;
  blind.bearing_step_rad = kPi / 180.0;
  blind.max_range_m = 50.0;
  blind.ranges_m.assign(180, 81.83);
  for (int i = 0; i < 20; ++i) mapper.add(blind);
  const Map track = mapper.finish();
  ASSERT_EQ(track.scans.size(), 20U);
  for (const MappedScan& mapped : track.scans) EXPECT_EQ(mapped.status, TrackStatus::kLost);
  EXPECT_TRUE(track.keyframes.empty());
}

TEST(Mapper, RefusesPosesThatAreNotFinite) {
  Mapper mapper;
  Scan scan;
  scan.bearing_step_rad = kPi / 180.0;
  scan.max_range_m = 50.0;
  scan.ranges_m.assign(180, 2.0);
  EXPECT_THROW(mapper.add(scan, Pose2{std::nan(""), 0.0, 0.0}), ParameterError);
  scan.T_base_sensor.theta_rad = std::numeric_limits<double>::infinity();
  EXPECT_THROW(mapper.add(scan), ParameterError);
  EXPECT_EQ(mapper.num_scans(), 0U);
}

TEST(Mapper, RefusesAScanThatIsNone) {
  Mapper mapper;
  Scan scan;
  scan.ranges_m = {1.0, 2.0};
  scan.bearing_step_rad = 0.0;
  EXPECT_THROW(mapper.add(scan), ParameterError);
}

}  // namespace setsquare::mapper_test
