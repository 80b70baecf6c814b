// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Many random pairs in furnished rooms: how often the matcher is right, and whether its information
// matches its errors.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "setsquare/matching/scan_matcher.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::scan_matcher_random_rooms_test {

using testing::uniform;

struct Tally {
  int num_pairs = 0;
  int num_tight = 0;
  int num_matched = 0;
  int num_wrong = 0;
  double sum_nees = 0.0;  ///< Of right matches: error' information error, 3 where consistent.

  void add(const MatchResult& result, const Pose2& truth) {
    ++num_pairs;
    if (!result.T_reference_current) return;
    const Pose2& found = *result.T_reference_current;
    const Eigen::Vector3d error(found.x_m - truth.x_m,
                                found.y_m - truth.y_m,
                                wrap_to_pi(found.theta_rad - truth.theta_rad));
    const double distance_m = error.head<2>().norm();
    const double rotation_rad = std::abs(error.z());
    num_tight += distance_m < 0.05 && rotation_rad < rad_from_deg(1.0);
    if (result.status != MatchStatus::kMatched) return;
    ++num_matched;
    if (distance_m > 0.2 || rotation_rad > rad_from_deg(3.0)) {
      ++num_wrong;
    } else {
      sum_nees += error.dot(result.information * error);
    }
  }
  [[nodiscard]] double mean_nees() const { return sum_nees / (num_matched - num_wrong); }
};

void tell(const char* name, const Tally& tally) {
  std::cout << name << ": " << tally.num_pairs << " pairs, " << tally.num_tight << " tight, "
            << tally.num_matched << " matched, " << tally.num_wrong << " wrong, mean NEES "
            << tally.mean_nees() << "\n";
}

/// Pairs whose scans truly overlap by the share at least; noise of 1 to 2 cm, every tenth beam
/// lost.
Tally match_random_pairs(const testing::Fan& fan, double min_overlap, int num_pairs) {
  auto generator = testing::make_generator();
  Tally tally;
  while (tally.num_pairs < num_pairs) {
    const auto room = testing::furnished_room(generator);
    const Pose2 T_world_reference = testing::free_pose(room, generator);
    const Pose2 T_world_current = testing::free_pose(room, generator);
    const auto scan = [&](const Pose2& T) {
      const double noise_m = uniform(generator, 0.01, 0.02);
      return testing::scan_of_walls(room.walls, T, fan, noise_m, generator(), 0.1);
    };
    const Scan reference = scan(T_world_reference);
    const Scan current = scan(T_world_current);
    const Pose2 truth = T_world_reference.inverse() * T_world_current;
    const bool is_shared =
        std::min(testing::true_overlap(reference, current, truth),
                 testing::true_overlap(current, reference, truth.inverse())) >= min_overlap;
    if (is_shared) tally.add(match(reference, current), truth);
  }
  return tally;
}

// Bounds for any seed; the figures of ten seeds are next to them.
TEST(RandomRooms, ScansThatShareMostOfWhatTheySeeAreMatched) {
  const testing::Fan full_turn{720, rad_from_deg(-180), rad_from_deg(0.5)};
  const Tally tally = match_random_pairs(full_turn, 0.6, 150);
  tell("full turn, overlap >= 60 %", tally);
  EXPECT_GE(tally.num_tight, 147);
  EXPECT_GE(tally.num_matched, 145);
  EXPECT_EQ(tally.num_wrong, 0);
  // The information claims what is true: 3 on average.
  EXPECT_LT(tally.mean_nees(), 5.0);
  EXPECT_GT(tally.mean_nees(), 1.2);
}

TEST(RandomRooms, HalfTurnScansThatShareMostAreMatched) {
  const testing::Fan half_turn{361, rad_from_deg(-90), rad_from_deg(0.5)};
  const Tally tally = match_random_pairs(half_turn, 0.6, 100);
  tell("half turn, overlap >= 60 %", tally);
  EXPECT_GE(tally.num_tight, 96);
  // A corner of a rectangle looks like another of its corners: where that explains 70 % as much,
  // a right answer does not stand either.
  EXPECT_GE(tally.num_matched, 55);
  EXPECT_LE(tally.num_wrong, 1);
  EXPECT_LT(tally.mean_nees(), 5.0);
  EXPECT_GT(tally.mean_nees(), 1.2);
}

TEST(RandomRooms, HalfTurnScansThatHardlyOverlapAreSeldomMatchedWrongly) {
  const testing::Fan half_turn{361, rad_from_deg(-90), rad_from_deg(0.5)};
  const Tally tally = match_random_pairs(half_turn, 0.0, 300);
  tell("half turn, any overlap", tally);
  EXPECT_LE(tally.num_wrong, 9);
}

}  // namespace setsquare::scan_matcher_random_rooms_test
