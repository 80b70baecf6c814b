// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/scan/scan.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "setsquare/core/error.hpp"

namespace setsquare::scan_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Scan half_turn(std::vector<double> ranges_m) {
  Scan scan;
  scan.first_bearing_rad = -0.5 * kPi;
  scan.bearing_step_rad = rad_from_deg(1.0);
  scan.min_range_m = 0.1;
  scan.max_range_m = 50.0;
  scan.ranges_m = std::move(ranges_m);
  return scan;
}

TEST(Scan, JudgesEveryKindOfRange) {
  const Scan scan =
      half_turn({1.0, kNan, 0.0, -1.0, 0.05, 0.1, 49.9, 50.0, 81.83, kInfinity, -kInfinity});
  const std::vector<BeamOutcome> expected = {BeamOutcome::kReturn,
                                             BeamOutcome::kInvalid,
                                             BeamOutcome::kInvalid,
                                             BeamOutcome::kInvalid,
                                             BeamOutcome::kInvalid,
                                             BeamOutcome::kReturn,
                                             BeamOutcome::kReturn,
                                             BeamOutcome::kNoReturn,
                                             BeamOutcome::kNoReturn,
                                             BeamOutcome::kNoReturn,
                                             BeamOutcome::kInvalid};
  for (std::size_t beam = 0; beam < expected.size(); ++beam) {
    EXPECT_EQ(scan.outcome(beam), expected[beam]) << "range " << scan.ranges_m[beam];
  }
}

TEST(Scan, ARangeInsideTheScannerIsACode) {
  Scan scan = half_turn({0.001, 0.019, 0.029, 0.03});
  scan.min_range_m = 0.0;
  for (const std::size_t beam : {0U, 1U, 2U}) {
    EXPECT_EQ(scan.outcome(beam), BeamOutcome::kInvalid);
  }
  EXPECT_EQ(scan.outcome(3), BeamOutcome::kReturn);
}

TEST(Scan, InfinityIsNoReturnEvenWithoutALimit) {
  Scan scan = half_turn({kInfinity, 1e6});
  scan.max_range_m = kInfinity;
  EXPECT_EQ(scan.outcome(0), BeamOutcome::kNoReturn);
  EXPECT_EQ(scan.outcome(1), BeamOutcome::kReturn);
}

TEST(Scan, FieldOfViewLiesBetweenTheOutermostBeams) {
  EXPECT_NEAR(half_turn(std::vector<double>(181, 1.0)).field_of_view_rad(), kPi, 1e-12);
  EXPECT_EQ(half_turn({1.0}).field_of_view_rad(), 0.0);
  EXPECT_EQ(half_turn({}).field_of_view_rad(), 0.0);
  Scan clockwise = half_turn(std::vector<double>(91, 1.0));
  clockwise.bearing_step_rad = -rad_from_deg(1.0);
  EXPECT_NEAR(clockwise.field_of_view_rad(), 0.5 * kPi, 1e-12);
  EXPECT_NEAR(clockwise.bearing_rad(90), -kPi, 1e-12);
}

TEST(Scan, ValidateAcceptsScansOfRealSensors) {
  EXPECT_NO_THROW(half_turn({}).validate());
  EXPECT_NO_THROW(half_turn({1.0}).validate());
  EXPECT_NO_THROW(half_turn(std::vector<double>(360, 1.0)).validate());
  Scan lidar = half_turn(std::vector<double>(1081, 1.0));
  lidar.bearing_step_rad = rad_from_deg(0.25);
  EXPECT_NO_THROW(lidar.validate());
}

TEST(Scan, ValidateNamesTheFieldThatIsNoScans) {
  const auto complaint = [](const Scan& scan) -> std::string {
    try {
      scan.validate();
    } catch (const ParameterError& error) {
      return error.what();
    }
    return "";
  };
  Scan scan = half_turn({1.0, 2.0});
  scan.first_bearing_rad = kNan;
  EXPECT_NE(complaint(scan).find("first_bearing_rad"), std::string::npos);
  scan = half_turn({1.0, 2.0});
  scan.bearing_step_rad = 0.0;
  EXPECT_NE(complaint(scan).find("bearing_step_rad"), std::string::npos);
  EXPECT_NE(complaint(half_turn(std::vector<double>(400, 1.0))).find("turn"), std::string::npos);
  scan = half_turn({1.0});
  scan.max_range_m = 0.05;
  EXPECT_NE(complaint(scan).find("max_range_m"), std::string::npos);
}

}  // namespace setsquare::scan_test
