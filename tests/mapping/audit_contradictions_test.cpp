// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Which contradictions raise a doubt, by made-up matches along a corridor and back.
#include <gtest/gtest.h>

#include <cmath>

#include "setsquare/core/angle.hpp"
#include "setsquare/mapping/audit/contradictions.hpp"

namespace setsquare::audit_contradictions_test {

constexpr std::size_t kHalf = 80;  ///< Keyframes there, and as many back, 0.5 m apart.

/// 40 m along a corridor and back beside it.
AuditedTrack there_and_back() {
  AuditedTrack track;
  for (std::size_t k = 0; k < 2 * kHalf; ++k) {
    const bool is_back = k >= kHalf;
    const double x_m = 0.5 * static_cast<double>(is_back ? 2 * kHalf - 1 - k : k);
    track.keyframes.push_back(k);
    track.T_map_sensor.push_back({x_m, is_back ? 1.0 : 0.0, is_back ? -kPi : 0.0});
    track.way_m.push_back(0.5 * static_cast<double>(k));
    track.open_m2.push_back(0.0);
  }
  return track;
}

/// The keyframe of the way back beside that of the way there.
std::size_t beside(std::size_t k) { return 2 * kHalf - 1 - k; }

/// A match that would have the later keyframe moved by `T_map_moved` about where the map has it.
AuditMatch moved_match(const AuditedTrack& track,
                       std::size_t from,
                       std::size_t to,
                       const Pose2& T_map_moved) {
  const Pose2& T_map_to = track.T_map_sensor[to];
  const Pose2 moved{T_map_to.x_m + T_map_moved.x_m,
                    T_map_to.y_m + T_map_moved.y_m,
                    wrap_to_pi(T_map_to.theta_rad + T_map_moved.theta_rad)};
  return {{from, to}, track.T_map_sensor[from].inverse() * moved, Eigen::Matrix3d::Identity()};
}

/// A match that would have the map corrected by a rigid motion about the later keyframe.
AuditMatch corrected_match(const AuditedTrack& track,
                           std::size_t from,
                           std::size_t to,
                           const Pose2& T_map_corrected) {
  return {{from, to},
          track.T_map_sensor[from].inverse() * T_map_corrected * track.T_map_sensor[to],
          Eigen::Matrix3d::Identity()};
}

/// Matches of so many places, 1 m apart, that would have the way back moved.
std::vector<AuditMatch> moved_matches(const AuditedTrack& track,
                                      std::size_t first,
                                      std::size_t num,
                                      const Pose2& T_map_moved) {
  std::vector<AuditMatch> matches;
  for (std::size_t i = 0; i < num; ++i) {
    const std::size_t k = first + 2 * i;
    matches.push_back(moved_match(track, k, beside(k), T_map_moved));
  }
  return matches;
}

void append(std::vector<AuditMatch>& matches, const std::vector<AuditMatch>& more) {
  matches.insert(matches.end(), more.begin(), more.end());
}

bool raises_doubt(const std::vector<AuditMatch>& matches, const AuditedTrack& track) {
  const auto groups = contradiction_groups(matches, track, {});
  return !groups.empty() && groups.front().raises_doubt;
}

TEST(AuditContradictions, PlacesThatAskForTheSameCorrectionRaiseADoubt) {
  const AuditedTrack track = there_and_back();
  const Pose2 moved{0.8, 0.3, rad_from_deg(3.0)};
  const auto groups = contradiction_groups(moved_matches(track, 10, 4, moved), track, {});
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups.front().num_places, 4U);
  EXPECT_EQ(groups.front().num_agreeing, 0U);
  EXPECT_TRUE(groups.front().raises_doubt);
}

TEST(AuditContradictions, FewerPlacesThanTheParameterSaysDoNot) {
  const AuditedTrack track = there_and_back();
  const AuditParams params;
  const Pose2 moved{0.8, 0.0, 0.0};
  EXPECT_FALSE(raises_doubt(moved_matches(track, 10, params.min_seconded - 1, moved), track));
  EXPECT_TRUE(raises_doubt(moved_matches(track, 10, params.min_seconded, moved), track));
}

TEST(AuditContradictions, TheSamePlaceSeenOftenIsOne) {
  const AuditedTrack track = there_and_back();
  const AuditMatch match = moved_match(track, 10, beside(10), {0.8, 0.0, 0.0});
  const auto groups = contradiction_groups(std::vector<AuditMatch>(6, match), track, {});
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups.front().members.size(), 6U);
  EXPECT_EQ(groups.front().num_places, 1U);
  EXPECT_FALSE(groups.front().raises_doubt);
}

TEST(AuditContradictions, ContradictionsThatDifferDoNotSecondEachOther) {
  const AuditedTrack track = there_and_back();
  std::vector<AuditMatch> matches;
  for (const double x_m : {-3.0, -1.0, 1.0, 3.0}) {
    const std::size_t k = 10 + 2 * matches.size();
    matches.push_back(moved_match(track, k, beside(k), {x_m, 0.0, 0.0}));
  }
  const auto groups = contradiction_groups(matches, track, {});
  EXPECT_EQ(groups.size(), 4U);
  EXPECT_FALSE(raises_doubt(matches, track));
}

TEST(AuditContradictions, TheMajorityOfTheSamePartsCounts) {
  const AuditedTrack track = there_and_back();
  std::vector<AuditMatch> matches = moved_matches(track, 10, 4, {0.8, 0.0, 0.0});
  append(matches, moved_matches(track, 11, 2, {}));
  EXPECT_TRUE(raises_doubt(matches, track)) << "4 against 2";
  append(matches, moved_matches(track, 15, 1, {}));
  EXPECT_FALSE(raises_doubt(matches, track)) << "4 against 3";
}

TEST(AuditContradictions, WhatAgreesElsewhereDoesNotCount) {
  const AuditedTrack track = there_and_back();
  std::vector<AuditMatch> matches = moved_matches(track, 10, 4, {0.8, 0.0, 0.0});
  append(matches, moved_matches(track, 50, 8, {}));
  EXPECT_TRUE(raises_doubt(matches, track));
}

TEST(AuditContradictions, CornersThatLookAlikeTurnedAreNoErrorOfTracking) {
  AuditedTrack track = there_and_back();
  for (const double turn_rad : {kQuarterTurn, kPi, -kQuarterTurn}) {
    const Pose2 T_map_middle{32.0, 0.5, 0.0};
    const Pose2 turned = T_map_middle * Pose2{0.0, 0.0, turn_rad} * T_map_middle.inverse();
    std::vector<AuditMatch> matches;
    for (std::size_t k = 60; k < 70; k += 2) {
      matches.push_back(corrected_match(track, k, beside(k), turned));
    }
    EXPECT_FALSE(raises_doubt(matches, track)) << turn_rad;
    // Where tracking began anew nothing is known of the turn.
    track.restarts = {kHalf};
    EXPECT_TRUE(raises_doubt(matches, track)) << turn_rad;
    track.restarts.clear();
  }
}

TEST(AuditContradictions, ANicheEverySoManyMetresIsNoErrorOfTheMap) {
  // The way back is tied to the way there all along by matches that agree: no way between the two
  // places is long enough to have lost 6 m.
  const AuditedTrack track = there_and_back();
  std::vector<AuditMatch> aliases;
  for (const std::size_t k : {4U, 6U, 8U, 10U, 12U}) {
    const std::size_t alike = beside(k + 12);
    aliases.push_back(moved_match(track, k, alike, {-6.0, 0.0, 0.0}));
  }
  std::vector<AuditMatch> tied = aliases;
  append(tied, moved_matches(track, 3, 38, {}));
  EXPECT_FALSE(raises_doubt(tied, track));
  EXPECT_TRUE(raises_doubt(aliases, track)) << "the same, and nothing ties the way back";
}

TEST(AuditContradictions, ALostScanLeavesRoomForMore) {
  AuditedTrack track = there_and_back();
  std::vector<AuditMatch> matches = moved_matches(track, 70, 5, {1.8, 0.0, 0.0});
  EXPECT_FALSE(raises_doubt(matches, track)) << "5 to 10 m of way";
  track.losses = {kHalf};
  EXPECT_TRUE(raises_doubt(matches, track));
}

TEST(AuditContradictions, WhatTheMapAdmitsDoesNotContradictIt) {
  AuditedTrack track = there_and_back();
  const AuditMatch match = moved_match(track, 10, beside(10), {0.8, 0.0, 0.0});
  EXPECT_TRUE(audit_offset(match, track, {}).contradicts_map);
  for (std::size_t k = kHalf; k < track.size(); ++k) track.open_m2[k] = 0.3 * 0.3;
  EXPECT_FALSE(audit_offset(match, track, {}).contradicts_map) << "three spreads are 0.9 m";
  const AuditMatch turned = moved_match(track, 10, beside(10), {0.0, 0.0, rad_from_deg(6.0)});
  EXPECT_TRUE(audit_offset(turned, track, {}).contradicts_map);
}

}  // namespace setsquare::audit_contradictions_test
