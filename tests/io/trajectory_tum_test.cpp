// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/tables/trajectory_tum.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bytes/byte_source.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/seed.hpp"
#include "tests/support/temporary_folder.hpp"

namespace setsquare::trajectory_tum_test {

using ::testing::HasSubstr;
using ::testing::SizeIs;

TEST(TrajectoryTum, WritesWhatEvoReads) {
  EXPECT_EQ(tum_from_trajectory({{Timestamp{976052857337530000}, {1.5, -2.25, kPi / 2.0}}}),
            "976052857.337530 1.500000 -2.250000 0 0 0 0.707106781 0.707106781\n");
}

TEST(TrajectoryTum, RoundTrip) {
  auto generator = testing::make_generator();
  Trajectory trajectory;
  for (int i = 0; i < 1000; ++i) {  // stamps run backwards at times, as real ones do
    const auto us = static_cast<std::int64_t>(testing::uniform(generator, -1e12, 1e15));
    trajectory.push_back({Timestamp{us * 1000},
                          {testing::uniform(generator, -1e3, 1e3),
                           testing::uniform(generator, -1e3, 1e3),
                           testing::uniform(generator, -kPi, kPi)}});
  }
  const testing::TemporaryFolder folder;
  const auto path = folder.path() / "track.tum";
  write_trajectory_tum(path.string(), trajectory);
  const Trajectory again = read_trajectory_tum(path.string());
  ASSERT_EQ(again.size(), trajectory.size());
  for (std::size_t i = 0; i < again.size(); ++i) {
    EXPECT_EQ(again[i].stamp, trajectory[i].stamp);
    EXPECT_THAT(
        again[i].pose,
        testing::PoseNear(trajectory[i].pose,
                          testing::PoseTolerance{.translation_m = 1e-6, .rotation_rad = 3e-9}));
  }
}

// Headings of 0, 60 and 120 deg, quaternions written w first.
TEST(TrajectoryTum, QuaternionsThatAreWrittenWFirstLieOnTheirSide) {
  const std::string text = "1 0 0 0 1 0 0 0\n2 0 0 0 0.866025 0 0 0.5\n3 0 0 0 0.5 0 0 0.866025\n";
  const TumReading as_tum = read_tum(make_memory_source(text), "x");
  EXPECT_EQ(as_tum.num_tilted, 3U) << "by 180, 120 and 60 deg";
  const TumReading w_first = read_tum(make_memory_source(text), "x", QuaternionOrder::kWFirst);
  EXPECT_EQ(w_first.num_tilted, 0U);
  EXPECT_NEAR(w_first.trajectory[1].pose.theta_rad, rad_from_deg(60.0), 1e-5);
  EXPECT_NEAR(w_first.trajectory[2].pose.theta_rad, rad_from_deg(120.0), 1e-5);
}

TEST(TrajectoryTum, TheLargestNumbersFit) {
  const std::string text = tum_from_trajectory({{Timestamp{}, {-1.7e308, -1.7e308, 0.0}}});
  EXPECT_THAT(read_trajectory_tum(make_memory_source(text), "x"), SizeIs(1));
}

TEST(TrajectoryTum, ADamagedLineIsNamed) {
  try {
    static_cast<void>(read_trajectory_tum(make_memory_source("1 2 3 0 0 0 0 1\n1 2 3\n"), "x.tum"));
    FAIL() << "a damaged line was taken";
  } catch (const FormatError& error) {
    EXPECT_THAT(error.what(), HasSubstr("x.tum, line 2: expected \"stamp x y z qx qy qz qw\""));
  }
}

TEST(TrajectoryTum, RelationsAreNoTrajectory) {
  // As many numbers in a line: two stamps, x y z, roll pitch yaw.
  const std::string relation = "976052890.24 976052891.73 0.42 0.02 0 0 0 -0.05\n";
  try {
    static_cast<void>(read_trajectory_tum(make_memory_source("1 2 3 0 0 0 0 1\n" + relation), "x"));
    FAIL() << "relations were taken for a trajectory";
  } catch (const FormatError& error) {
    EXPECT_THAT(error.what(), HasSubstr("stamp 976052890.24"));
    EXPECT_THAT(error.what(), HasSubstr("no rotation"));
  }
  const std::string rounded = "1 2 3 0 0 0 0.707 0.707\n";
  EXPECT_THAT(read_trajectory_tum(make_memory_source(rounded), "x"), SizeIs(1));
}

TEST(TrajectoryTum, NothingIsLeftWhereItCannotBeWritten) {
  EXPECT_THROW(write_trajectory_tum("/no/such/folder/t.tum", {}), FileError);
}

}  // namespace setsquare::trajectory_tum_test
