// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A corridor with a niche every two metres on both sides, its ends out of sight: moved by two
// metres it looks the same, and nothing else speaks against the wrong pose.
#include "setsquare/matching/aliases.hpp"

#include <gtest/gtest.h>

#include "setsquare/matching/scan_matcher.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::aliases_test {

using testing::uniform;

const testing::Fan kWide{1081, rad_from_deg(-135), rad_from_deg(0.25)};
constexpr double kPeriod_m = 2.0;

/// A wall along y from x = -40 to 40 with a niche of 0.9 m by 0.4 m every two metres.
void add_wall_with_niches(double y_m, double depth_m, std::vector<testing::Wall>& walls) {
  for (double x_m = -40.0; x_m < 40.0; x_m += kPeriod_m) {
    const double begin_m = x_m + 1.1;
    const double end_m = x_m + kPeriod_m;
    walls.push_back({x_m, y_m, begin_m, y_m});
    walls.push_back({begin_m, y_m, begin_m, y_m + depth_m});
    walls.push_back({begin_m, y_m + depth_m, end_m, y_m + depth_m});
    walls.push_back({end_m, y_m + depth_m, end_m, y_m});
  }
}

std::vector<testing::Wall> corridor_with_niches() {
  std::vector<testing::Wall> walls;
  add_wall_with_niches(1.2, 0.4, walls);
  add_wall_with_niches(-1.2, -0.4, walls);
  return walls;
}

Candidate candidate_at(const PreparedScan& reference, const PreparedScan& current, const Pose2& T) {
  const Alignment alignment =
      align(reference.fine_alignment(), current.fine_alignment(), T, ScoreParams{}.tolerance_m);
  return {.T_reference_current = T,
          .evidence = alignment.evidence,
          .score = score(alignment.evidence, {})};
}

/// Of the motion by `shift_m` along x, for two scans 0.5 m apart.
std::vector<Pose2> aliases_at(const std::vector<testing::Wall>& walls, double shift_m) {
  const Pose2 T_world_reference{0.3, 0.1, 0.0};
  const Pose2 T_world_current{0.8, -0.1, 0.0};
  const PreparedScan reference =
      prepare(testing::scan_of_walls(walls, T_world_reference, kWide, 0.01, 1));
  const PreparedScan current =
      prepare(testing::scan_of_walls(walls, T_world_current, kWide, 0.01, 2));
  const Pose2 T = T_world_reference.inverse() * T_world_current;
  const std::vector<Candidate> candidates{
      candidate_at(reference, current, T),
      candidate_at(reference, current, Pose2{shift_m, 0.0, 0.0} * T)};
  constexpr double kTight_m = 20.0;
  return find_aliases(reference, current, candidates, kTight_m, {});
}

TEST(Aliases, APeriodIsOneAndAnyOtherShiftIsNone) {
  for (const double sign : {-1.0, 1.0}) {
    const std::vector<Pose2> found = aliases_at(corridor_with_niches(), sign * kPeriod_m);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found.front().x_m, sign * kPeriod_m, 1e-9);
    EXPECT_NEAR(found.front().y_m, 0.0, 1e-9);
    EXPECT_TRUE(aliases_at(corridor_with_niches(), sign * 1.0).empty());
  }
}

// Its walls agree with themselves under any motion along it; nothing holds them there.
TEST(Aliases, ABareCorridorHasNone) {
  const std::vector<testing::Wall> bare{{-40.0, 1.2, 40.0, 1.2}, {-40.0, -1.2, 40.0, -1.2}};
  EXPECT_TRUE(aliases_at(bare, kPeriod_m).empty());
}

/// Pairs some metres apart in the corridor: how many are `matched`, and whether they say the
/// period.
struct CorridorTally {
  int num_matched = 0;
  int num_aliases = 0;
  int num_of_the_period = 0;  ///< Aliases that are a multiple of it.
};

CorridorTally match_in_corridor(const MatchParams& params) {
  auto generator = testing::make_generator();
  const auto walls = corridor_with_niches();
  CorridorTally tally;
  for (int trial = 0; trial < 60; ++trial) {
    const auto any_pose = [&] {
      return Pose2{uniform(generator, -3.0, 3.0), uniform(generator, -0.5, 0.5), 0.0};
    };
    const Scan reference = testing::scan_of_walls(walls, any_pose(), kWide, 0.02, generator());
    const Scan current = testing::scan_of_walls(walls, any_pose(), kWide, 0.02, generator());
    const MatchResult result = match(reference, current, params);
    tally.num_matched += result.status == MatchStatus::kMatched;
    if (!result.alias) continue;
    ++tally.num_aliases;
    EXPECT_NE(result.status, MatchStatus::kMatched);
    EXPECT_LE(result.probability, 0.5);
    tally.num_of_the_period +=
        std::abs(wrap_to_period(result.alias->x_m, kPeriod_m)) < 0.05 ||
        std::abs(wrap_to_pi(result.alias->theta_rad)) > 3.0;  // A half turn is one, too.
  }
  return tally;
}

TEST(Aliases, ACorridorWithNichesIsAmbiguousAndItsPeriodIsTold) {
  const CorridorTally tally = match_in_corridor({});
  EXPECT_EQ(tally.num_matched, 0);
  EXPECT_GE(tally.num_aliases, 50);
  EXPECT_EQ(tally.num_of_the_period, tally.num_aliases);
}

TEST(Aliases, WithoutTheRuleTheCorridorDeceives) {
  MatchParams params;
  params.alias.min_constraint_m = 1e9;
  EXPECT_GE(match_in_corridor(params).num_matched, 1);
}

// The rule costs nothing where nothing repeats.
TEST(Aliases, FurnishedRoomsHaveHardlyAny) {
  auto generator = testing::make_generator();
  int num_aliases = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const auto room = testing::furnished_room(generator);
    const auto scan = [&] {
      return testing::scan_of_walls(
          room.walls, testing::free_pose(room, generator), kWide, 0.01, generator());
    };
    num_aliases += match(scan(), scan()).alias.has_value();
  }
  EXPECT_LE(num_aliases, 1);
}

}  // namespace setsquare::aliases_test
