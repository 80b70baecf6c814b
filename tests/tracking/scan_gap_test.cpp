// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/scan_gap.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <vector>

#include "tests/support/seed.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare::scan_gap_test {

using testing::l_shaped_room;
using testing::make_generator;
using testing::scan_of_walls;
using testing::uniform;

Scan scan_at(double stamp_s, const Pose2& pose = {1.0, 1.0, 0.0}) {
  Scan scan = scan_of_walls(l_shaped_room(), pose);
  scan.stamp.ns = static_cast<std::int64_t>(stamp_s * 1e9);
  return scan;
}

const Pose2 kElsewhere{2.0, 6.0, 1.0};

TEST(ScanGap, AnEvenLogHasNoneWhateverItsPeriod) {
  for (const double period_s : {0.02, 0.2, 1.0, 5.0}) {
    ScanGap gap({});
    for (int i = 0; i < 20; ++i) {
      EXPECT_FALSE(gap.add(scan_at(i * period_s, i % 2 == 0 ? Pose2{1.0, 1.0, 0.0} : kElsewhere)))
          << period_s;
    }
  }
}

TEST(ScanGap, ALongPauseIsOneOnce) {
  ScanGap gap({});
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(gap.add(scan_at(0.2 * i)));
  EXPECT_FALSE(gap.add(scan_at(4.0, kElsewhere))) << "2.2 s: tracking's business";
  EXPECT_TRUE(gap.add(scan_at(8.0)));
  EXPECT_FALSE(gap.add(scan_at(8.2, kElsewhere)));
}

TEST(ScanGap, NotWhereTheRobotSeesWhatItSaw) {
  ScanGap gap({});
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(gap.add(scan_at(0.2 * i)));
  EXPECT_FALSE(gap.add(scan_at(60.0, {1.01, 1.0, 0.002})));
  EXPECT_TRUE(gap.add(scan_at(120.0, kElsewhere)));
}

TEST(ScanGap, NotWhereStampsRunBackwards) {
  ScanGap gap({});
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(gap.add(scan_at(100.0 + 0.2 * i)));
  EXPECT_FALSE(gap.add(scan_at(3.0, kElsewhere)));
  EXPECT_FALSE(gap.add(scan_at(3.2)));
}

TEST(ScanGap, AStampThatJumpsBackMakesNoneOnTheWayForward) {
  auto generator = make_generator();
  for (int run = 0; run < 20; ++run) {
    ScanGap gap({});
    bool jumped = true;  // No two stamps in a row do.
    for (int i = 0; i < 60; ++i) {
      jumped = !jumped && uniform(generator, 0.0, 1.0) < 0.2;
      const double back_s = jumped ? uniform(generator, 0.0, 100.0) : 0.0;
      const Pose2 pose = i % 2 == 0 ? Pose2{1.0, 1.0, 0.0} : kElsewhere;
      EXPECT_FALSE(gap.add(scan_at(1000.0 + 0.2 * i - back_s, pose)))
          << "run " << run << ", scan " << i;
    }
    EXPECT_TRUE(gap.add(scan_at(1030.0, {2.0, 3.0, 2.0})));
  }
}

TEST(ScanGap, AStampThatJumpsBackAtFirstGivesNoUsualPause) {
  ScanGap gap({});
  for (const double stamp_s : {10.0, 6.0, 10.2, 10.4, 10.6})
    EXPECT_FALSE(gap.add(scan_at(stamp_s)));
  EXPECT_TRUE(gap.add(scan_at(14.0, kElsewhere)));
}

TEST(ScanGap, IsFoundAfterTheClockWasSetBackForGood) {
  ScanGap gap({});
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(gap.add(scan_at(1000.0 + 0.2 * i)));
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(gap.add(scan_at(3.0 + 0.2 * i)));
  EXPECT_TRUE(gap.add(scan_at(9.0, kElsewhere)));
  EXPECT_FALSE(gap.add(scan_at(9.2)));
}

TEST(ScanGap, ScansThatSeeNothingAreNotAlike) {
  ScanGap gap({});
  const auto blind_at = [](double stamp_s) {
    Scan scan = scan_at(stamp_s);
    scan.ranges_m.assign(scan.ranges_m.size(), std::numeric_limits<double>::quiet_NaN());
    return scan;
  };
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(gap.add(blind_at(0.2 * i)));
  EXPECT_TRUE(gap.add(blind_at(60.0)));
}

TEST(ScanGap, AScannerIsComparedWithItsOwnLastScan) {
  const auto scan_of = [](std::uint32_t scanner, double stamp_s, const Pose2& pose) {
    Scan scan = scan_at(stamp_s, pose);
    scan.scanner = scanner;
    return scan;
  };
  const Pose2 front{1.0, 1.0, 0.0};
  const Pose2 rear{0.5, 1.0, -3.0};
  ScanGap gap({});
  for (int i = 0; i < 10; ++i) {
    EXPECT_FALSE(gap.add(scan_of(0, 0.1 * i, front)));
    EXPECT_FALSE(gap.add(scan_of(1, 0.1 * i + 0.05, rear)));
  }
  EXPECT_FALSE(gap.add(scan_of(0, 20.0, front))) << "it stood still";
  EXPECT_FALSE(gap.add(scan_of(1, 20.05, rear)));
  EXPECT_TRUE(gap.add(scan_of(1, 40.0, kElsewhere)));
  EXPECT_FALSE(gap.add(scan_of(0, 40.05, kElsewhere))) << "the other scanner has found it";
  EXPECT_TRUE(gap.add(scan_of(2, 60.0, kElsewhere))) << "what it saw before is not known";
}

}  // namespace setsquare::scan_gap_test
