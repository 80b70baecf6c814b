// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A robot with a scanner in front and one behind.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "setsquare/map/map.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/simulated_drive.hpp"

namespace setsquare::mapper_scanners_test {

using testing::bare_corridor;
using testing::between;
using testing::drive;
using testing::Fan;
using testing::l_shaped_room;
using testing::PoseNear;
using testing::PoseTolerance;
using testing::scan_of_walls;
using testing::way_around_the_room;

constexpr double kNoise_m = 0.01;
constexpr Fan kWide{270, rad_from_deg(-135.0), rad_from_deg(1.0)};
const Pose2 kFront{0.25, 0.2, rad_from_deg(45.0)};
const Pose2 kRear{-0.25, -0.2, rad_from_deg(-135.0)};

/// A scan and where the robot truly was.
struct TakenScan {
  Scan scan;
  Pose2 T_world_base;
};

/// Scans of both scanners in turn, the robot moving on between them. `T_stated_true`: what the
/// rear one's mounting is off by.
std::vector<TakenScan> scans_of_both(const Pose2& T_stated_true = {}) {
  const std::vector<Pose2> T_world_base = drive(way_around_the_room(), 0.03, rad_from_deg(2.0));
  std::vector<TakenScan> taken;
  for (std::size_t i = 0; i < T_world_base.size(); ++i) {
    const bool is_rear = i % 2 == 1;
    const Pose2 T_base_true = is_rear ? kRear * T_stated_true : kFront;
    taken.push_back(
        {scan_of_walls(l_shaped_room(), T_world_base[i] * T_base_true, kWide, kNoise_m, i + 1),
         T_world_base[i]});
    Scan& scan = taken.back().scan;
    scan.T_base_sensor = is_rear ? kRear : kFront;
    scan.scanner = is_rear ? 1 : 0;
    scan.stamp.ns = static_cast<std::int64_t>(i) * 50'000'000;
  }
  return taken;
}

Map map_of(const std::vector<TakenScan>& taken, const MapperParams& params = {}) {
  Mapper mapper(params);
  for (const TakenScan& one : taken) mapper.add(one.scan);
  return mapper.finish();
}

std::vector<TakenScan> only_front(std::vector<TakenScan> taken) {
  std::erase_if(taken, [](const TakenScan& one) { return one.scan.scanner != 0; });
  return taken;
}

void expect_same_poses(const Map& a, const Map& b) {
  ASSERT_EQ(a.scans.size(), b.scans.size());
  for (std::size_t i = 0; i < a.scans.size(); ++i) {
    ASSERT_EQ(a.scans[i].T_map_base, b.scans[i].T_map_base) << i;
    ASSERT_EQ(a.scans[i].status, b.scans[i].status) << i;
  }
  EXPECT_EQ(a.keyframes, b.keyframes);
}

TEST(MapperScanners, ScansOfBothGoIntoOneMap) {
  const std::vector<TakenScan> taken = scans_of_both();
  const Map map = map_of(taken);
  ASSERT_EQ(map.scanners.size(), 2U);
  EXPECT_EQ(map.scanners[0].verdict, MountingVerdict::kReference);
  EXPECT_EQ(map.scanners[1].verdict, MountingVerdict::kConfirmed);
  EXPECT_GT(map.scanners[1].num_mapped, map.scanners[1].num_scans / 2);
  EXPECT_EQ(map.scanners[0].num_mapped + map.scanners[1].num_mapped, map.scans.size());
  std::size_t next = 0;
  for (const MappedScan& mapped : map.scans) {
    while (taken[next].scan.stamp != mapped.stamp) ++next;
    ASSERT_THAT(between(map.scans[0].T_map_base, mapped.T_map_base),
                PoseNear(between(taken[0].T_world_base, taken[next].T_world_base),
                         PoseTolerance{.translation_m = 0.05, .rotation_rad = rad_from_deg(0.5)}))
        << next;
    ASSERT_THAT(mapped.T_map_base * taken[next].scan.T_base_sensor,
                PoseNear(mapped.T_map_sensor, PoseTolerance{}));
  }
}

TEST(MapperScanners, BothLeaveKeyframes) {
  const std::vector<TakenScan> taken = scans_of_both();
  const Map map = map_of(taken);
  std::size_t num_rear = 0;
  for (const KeptScan& kept : map.kept_scans) {
    const auto& keyframes = map.keyframes;
    if (!std::binary_search(keyframes.begin(), keyframes.end(), kept.index)) continue;
    num_rear += kept.scan->scanner;
  }
  EXPECT_GT(num_rear, map.keyframes.size() / 4);
  EXPECT_LT(num_rear, map.keyframes.size() * 3 / 4);
}

/// How firmly the walls' directions hold the headings of a map.
double heading_information(const Map& map) {
  double sum_per_rad2 = 0.0;
  for (const MappedHeading& heading : map.headings) sum_per_rad2 += heading.information_per_rad2;
  return sum_per_rad2;
}

/// Both scanners see the same walls: what is off square about them is measured once.
TEST(MapperScanners, TheWallsDirectionsDoNotCountTwice) {
  MapperParams params;
  params.mounting.num_sightings = 0;
  const std::vector<TakenScan> taken = scans_of_both();
  const Map both = map_of(taken, params);
  const Map front = map_of(only_front(taken), params);
  EXPECT_GT(both.keyframes.size(), front.keyframes.size() * 3 / 2);
  EXPECT_NEAR(heading_information(both) / heading_information(front), 1.0, 0.15);
}

TEST(MapperScanners, AWrongMountingIsToldAndChangesNothing) {
  for (const Pose2& off : {Pose2{0.0, 0.0, rad_from_deg(5.0)},
                           Pose2{0.0, 0.0, rad_from_deg(-40.0)},
                           Pose2{0.0, 0.0, rad_from_deg(180.0)},
                           Pose2{0.3, -0.2, 0.0}}) {
    const std::vector<TakenScan> taken = scans_of_both(off);
    const Map map = map_of(taken);
    ASSERT_EQ(map.scanners.size(), 2U);
    const MappedScanner& rear = map.scanners[1];
    EXPECT_EQ(rear.verdict, MountingVerdict::kRefuted) << off.theta_rad << " " << off.x_m;
    EXPECT_EQ(rear.num_mapped, 0U);
    EXPECT_THAT(rear.T_base_seen,
                PoseNear(kRear * off,
                         PoseTolerance{.translation_m = 0.03, .rotation_rad = rad_from_deg(0.5)}));
    expect_same_poses(map, map_of(only_front(taken)));
  }
}

TEST(MapperScanners, AMirroredScannerFitsNowhere) {
  std::vector<TakenScan> taken = scans_of_both();
  for (TakenScan& one : taken) {
    if (one.scan.scanner == 1) std::reverse(one.scan.ranges_m.begin(), one.scan.ranges_m.end());
  }
  const Map map = map_of(taken);
  ASSERT_EQ(map.scanners.size(), 2U);
  EXPECT_NE(map.scanners[1].verdict, MountingVerdict::kConfirmed);
  expect_same_poses(map, map_of(only_front(taken)));
}

TEST(MapperScanners, ABlindScannerDoesNoHarm) {
  std::vector<TakenScan> taken = scans_of_both();
  for (TakenScan& one : taken) {
    if (one.scan.scanner == 1) one.scan.ranges_m.assign(kWide.num_beams, 31.0);
  }
  const Map map = map_of(taken);
  EXPECT_EQ(map.scanners[1].num_mapped, 0U);
  expect_same_poses(map, map_of(only_front(taken)));
}

TEST(MapperScanners, AScannerMayFallSilent) {
  std::vector<TakenScan> taken = scans_of_both();
  const std::size_t half = taken.size() / 2;
  taken.erase(std::remove_if(taken.begin() + static_cast<std::ptrdiff_t>(half),
                             taken.end(),
                             [](const TakenScan& one) { return one.scan.scanner == 0; }),
              taken.end());
  const Map map = map_of(taken);
  ASSERT_FALSE(map.scans.empty());
  EXPECT_THAT(between(map.scans.front().T_map_base, map.scans.back().T_map_base),
              PoseNear(between(taken.front().T_world_base, taken.back().T_world_base),
                       PoseTolerance{.translation_m = 0.05, .rotation_rad = rad_from_deg(0.5)}));
}

TEST(MapperScanners, WithoutATrialEveryMountingIsBelieved) {
  MapperParams params;
  params.mounting.num_sightings = 0;
  const std::vector<TakenScan> taken = scans_of_both();
  EXPECT_EQ(map_of(taken, params).scans.size(), taken.size());
}

TEST(MapperScanners, OneScannersMountingDoesNotChangeItsTrack) {
  std::vector<TakenScan> taken = only_front(scans_of_both());
  const Map mounted = map_of(taken);
  for (TakenScan& one : taken) one.scan.T_base_sensor = {};
  const Map bare = map_of(taken);
  for (std::size_t i = 0; i < taken.size(); ++i) {
    ASSERT_EQ(mounted.scans[i].T_map_sensor, bare.scans[i].T_map_sensor) << "to the last bit";
  }
}

}  // namespace setsquare::mapper_scanners_test
