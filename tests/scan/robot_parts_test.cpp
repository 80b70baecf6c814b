// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A scanner that turns in the middle of an oblong room, with things that turn with it or do not.
#include "setsquare/scan/robot_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "setsquare/core/angle.hpp"

namespace setsquare::robot_parts_test {

constexpr std::size_t kNumBeams = 360;

/// The walls of a room of 4 x 10 m, seen from its middle.
Scan room(double heading_rad) {
  Scan scan;
  scan.first_bearing_rad = -kPi;
  scan.bearing_step_rad = kTwoPi / static_cast<double>(kNumBeams);
  scan.max_range_m = 8.0;
  for (std::size_t beam = 0; beam < kNumBeams; ++beam) {
    const double at_rad = heading_rad + scan.bearing_rad(beam);
    scan.ranges_m.push_back(
        std::min(5.0 / std::abs(std::cos(at_rad)), 2.0 / std::abs(std::sin(at_rad))));
  }
  return scan;
}

/// What is found in scans of a robot that turns by 30 deg each.
RobotParts found_in(const std::function<void(std::size_t index, Scan& scan)>& change,
                    double turn_rad = rad_from_deg(30.0)) {
  RobotParts parts;
  for (std::size_t i = 0; i < 12; ++i) {
    Scan scan = room(turn_rad * static_cast<double>(i));
    change(i, scan);
    parts.add(scan);
  }
  return parts;
}

void put_post(std::size_t first_beam, double range_m, Scan& scan) {
  std::fill_n(scan.ranges_m.begin() + static_cast<std::ptrdiff_t>(first_beam), 12, range_m);
}

TEST(RobotParts, APostOfTheRobotIsFoundAndLeftOut) {
  const RobotParts parts = found_in([](std::size_t, Scan& scan) { put_post(100, 0.3, scan); });
  EXPECT_FALSE(parts.is_open());
  EXPECT_GT(parts.num_sectors(), 0U);
  Scan scan = room(0.1);
  put_post(100, 0.31, scan);
  const std::optional<Scan> without = parts.without(scan);
  ASSERT_TRUE(without);
  for (std::size_t beam = 0; beam < kNumBeams; ++beam) {
    const bool is_post = beam >= 100 && beam < 112;
    EXPECT_EQ(without->outcome(beam), is_post ? BeamOutcome::kInvalid : BeamOutcome::kReturn);
  }
}

TEST(RobotParts, WhereThePostIsNotSeenAScanStaysAsItIs) {
  const RobotParts parts = found_in([](std::size_t, Scan& scan) { put_post(100, 0.3, scan); });
  EXPECT_FALSE(parts.without(room(0.0)));
}

TEST(RobotParts, OnePostMayBeMissedOnceNotTwice) {
  const auto missed = [](std::size_t num) {
    return found_in([=](std::size_t i, Scan& scan) {
      if (i < 2 || i >= 2 + num) put_post(100, 0.3, scan);
    });
  };
  EXPECT_GT(missed(1).num_sectors(), 0U);
  EXPECT_EQ(missed(2).num_sectors(), 0U);
}

TEST(RobotParts, AThingBesideTheRobotIsNone) {
  const RobotParts parts =
      found_in([](std::size_t i, Scan& scan) { put_post((100 + 360 - 30 * i) % 348, 0.3, scan); });
  EXPECT_FALSE(parts.is_open());
  EXPECT_EQ(parts.num_sectors(), 0U);
}

TEST(RobotParts, NothingIsFoundWhileTheRobotStands) {
  const RobotParts parts = found_in([](std::size_t, Scan& scan) { put_post(100, 0.3, scan); }, 0.0);
  EXPECT_TRUE(parts.is_open());
  EXPECT_EQ(parts.num_sectors(), 0U);
}

TEST(RobotParts, AWallThatIsFollowedDoesNotEnd) {
  // The middle of a wall stays at 0.9 m, what lies beside it falls back and comes nearer.
  const RobotParts parts = found_in([](std::size_t i, Scan& scan) {
    put_post(100, 0.9, scan);
    for (std::size_t k = 0; k < 20; ++k) {
      const double off_m = 0.01 * static_cast<double>((k + 1) * (i % 2 + 1));
      scan.ranges_m[99 - k] = scan.ranges_m[112 + k] = 0.95 + off_m;
    }
  });
  EXPECT_FALSE(parts.is_open());
  EXPECT_EQ(parts.num_sectors(), 0U);
}

TEST(RobotParts, WithoutNearReturnsTheSearchEndsAtOnce) {
  RobotParts parts;
  parts.add(room(0.0));
  EXPECT_FALSE(parts.is_open());
}

}  // namespace setsquare::robot_parts_test
