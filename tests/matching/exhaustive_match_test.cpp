// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The plain twin of the whole search: every pose of a fine grid.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include "setsquare/matching/candidates.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/surfaces/alignment.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::exhaustive_match_test {

struct ScoredPose {
  Pose2 T_reference_current;
  double score = -1e9;
};

constexpr double kReach_m = 4.0;

double score_at(const PreparedScan& reference, const PreparedScan& current, const Pose2& T) {
  const ScoreParams params;
  const auto seen =
      align(reference.fine_alignment(), current.fine_alignment(), T, params.tolerance_m).evidence;
  return score(seen, params);
}

/// Scores every pose of a grid over the circle and a square of translations, walks from the best
/// few hundred to their peaks, and returns the highest.
ScoredPose match_exhaustively(const PreparedScan& reference, const PreparedScan& current) {
  constexpr double kStep_m = 0.16;
  constexpr int kNumRotations = 120;
  constexpr std::size_t kNumRefined = 300;
  std::vector<ScoredPose> poses;
  for (int turn = 0; turn < kNumRotations; ++turn) {
    for (double x_m = -kReach_m; x_m <= kReach_m; x_m += kStep_m) {
      for (double y_m = -kReach_m; y_m <= kReach_m; y_m += kStep_m) {
        const Pose2 T{x_m, y_m, wrap_to_pi(turn * kTwoPi / kNumRotations)};
        poses.push_back({T, score_at(reference, current, T)});
      }
    }
  }
  std::partial_sort(
      poses.begin(), poses.begin() + kNumRefined, poses.end(), [](const auto& a, const auto& b) {
        return a.score > b.score;
      });
  ScoredPose best;
  for (std::size_t i = 0; i < kNumRefined; ++i) {
    const std::vector<double> tolerances_m(6, ScoreParams{}.tolerance_m);
    const Pose2 T = refine(reference.fine_alignment(),
                           current.fine_alignment(),
                           poses[i].T_reference_current,
                           tolerances_m);
    const double refined = score_at(reference, current, T);
    if (refined > best.score) best = {T, refined};
  }
  return best;
}

TEST(ExhaustiveMatch, FindsNothingBetterThanTheSearch) {
  int num_found = 0;    // The same pose by both.
  int num_missed = 0;   // The search's score is lower by more than its last step.
  int num_outdone = 0;  // `matched` where another pose scores higher.
  auto generator = testing::make_generator();
  const testing::Fan fan{121, rad_from_deg(-120), rad_from_deg(2)};
  for (int trial = 0; trial < 8; ++trial) {
    SCOPED_TRACE(trial);
    const auto room = testing::furnished_room(generator);
    const Pose2 a = testing::free_pose(room, generator);
    const Pose2 b = testing::free_pose(room, generator);
    const PreparedScan reference =
        prepare(testing::scan_of_walls(room.walls, a, fan, 0.01, generator(), 0.03));
    const PreparedScan current =
        prepare(testing::scan_of_walls(room.walls, b, fan, 0.01, generator(), 0.03));
    const MatchResult found = match(reference, current);
    const ScoredPose best = match_exhaustively(reference, current);
    ASSERT_TRUE(found.T_reference_current.has_value());
    const auto& T = *found.T_reference_current;
    if (are_same(T, best.T_reference_current, {})) {
      ++num_found;
      continue;
    }
    // The searched scores stop a step short of their peaks.
    num_missed += found.score < best.score - 0.04;
    const bool is_within_reach = std::max(std::abs(T.x_m), std::abs(T.y_m)) < kReach_m;
    num_outdone += found.status == MatchStatus::kMatched && is_within_reach;
  }
  std::cout << num_found << " alike, " << num_missed << " missed, " << num_outdone << " outdone\n";
  EXPECT_GE(num_found, 4);
  EXPECT_LE(num_missed, 2);  // Low scores of scans that share little, none of them `matched`.
  EXPECT_EQ(num_outdone, 0);
}

}  // namespace setsquare::exhaustive_match_test
