// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Which closures are believed behind open stretches, by made-up matches: rooms in a ring of bare
// corridors, driven around once and on.
#include "setsquare/mapping/audit/closures_anywhere.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "setsquare/core/angle.hpp"

namespace setsquare::closures_anywhere_test {

constexpr std::size_t kPerLap = 320;  ///< Keyframes, 0.5 m apart: a square of 40 m.
constexpr std::size_t kPerSide = kPerLap / 4;

/// The true place of a keyframe.
Eigen::Vector2d place_of(std::size_t k) {
  const std::size_t side = (k / kPerSide) % 4;
  const double along_m = 0.5 * static_cast<double>(k % kPerSide);
  const Eigen::Vector2d corners[] = {{0.0, 0.0}, {40.0, 0.0}, {40.0, 40.0}, {0.0, 40.0}};
  return corners[side] + along_m / 40.0 * (corners[(side + 1) % 4] - corners[side]);
}

/// Headings are all 0, and from the second lap on the map is off by `off_m`.
AuditedTrack two_laps(const Eigen::Vector2d& off_m) {
  AuditedTrack track;
  for (std::size_t k = 0; k < 2 * kPerLap; ++k) {
    const Eigen::Vector2d p = place_of(k) + (k < kPerLap ? Eigen::Vector2d(0.0, 0.0) : off_m);
    track.keyframes.push_back(k);
    track.T_map_sensor.push_back({p.x(), p.y(), 0.0});
    track.way_m.push_back(0.5 * static_cast<double>(k));
    track.open_m2.push_back(0.1 * static_cast<double>(k));
    track.is_open.push_back(false);
  }
  return track;
}

/// A spread of so much per corridor along it; each room is known in itself.
WaySpread spread_of(double sigma_m) {
  return [sigma_m](std::size_t from, std::size_t to) {
    // Of each axis: the corridors that lie between.
    const auto num_before = [](std::size_t k, std::size_t axis) {
      const std::size_t side = (k + kPerSide / 2) / kPerSide;  // Rooms are half a side about it.
      return static_cast<double>(side / 2 + (axis == 0 ? side % 2 : 0));
    };
    Eigen::Matrix2d way_m2 = 1e-6 * Eigen::Matrix2d::Identity();
    for (int axis = 0; axis < 2; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      way_m2(axis, axis) += sigma_m * sigma_m * std::abs(num_before(to, a) - num_before(from, a));
    }
    return way_m2;
  };
}

/// A match of two keyframes that were each taken about a corner, as if both corners were one.
AuditMatch match_of(std::size_t from, std::size_t to, double turn_rad = 0.0) {
  const auto about_corner = [](std::size_t k) -> Eigen::Vector2d {
    return place_of(k) - place_of(k / kPerSide * kPerSide);
  };
  const Eigen::Vector2d told_m = about_corner(to) - about_corner(from);
  return {{from, to}, {told_m.x(), told_m.y(), turn_rad}, Eigen::Matrix3d::Identity()};
}

/// Matches of so many places at corner `room` of the first lap with those at corner `again` of the
/// second.
void match_room(std::size_t room,
                std::size_t again,
                std::vector<AuditMatch>& matches,
                std::size_t num = 4,
                double turn_rad = 0.0) {
  for (std::size_t i = 0; i < num; ++i) {
    const std::size_t to = kPerLap + again * kPerSide + 2 * i;
    matches.push_back(match_of(room * kPerSide + 2 * i, to, turn_rad));
  }
}

std::size_t num_believed(const std::vector<AuditMatch>& matches,
                         const AuditedTrack& track,
                         double sigma_m,
                         const ClosuresAnywhereParams& params = {}) {
  return believed_closures(matches, track, spread_of(sigma_m), params, {}).size();
}

TEST(ClosuresAnywhere, ThreeRoomsThatAgreeOverMoreThanTheSpreadAreBelieved) {
  const AuditedTrack track = two_laps({9.0, -7.0});
  std::vector<AuditMatch> matches;
  match_room(0, 0, matches);
  match_room(1, 1, matches);
  EXPECT_EQ(num_believed(matches, track, 15.0), 0U) << "two rooms extend along one axis only";
  match_room(2, 2, matches);
  EXPECT_EQ(num_believed(matches, track, 15.0), matches.size());
  EXPECT_EQ(num_believed(matches, track, 40.0), 0U) << "the spread is wider than the ring";
}

TEST(ClosuresAnywhere, OneRoomIsBelievedWhereNoTwinCouldLieBesideIt) {
  const AuditedTrack track = two_laps({0.8, 0.0});
  std::vector<AuditMatch> matches;
  match_room(0, 0, matches, 10);  // They extend over 9 m along x, and not at all along y.
  const auto spread_along_x = [](double sigma_m) {
    return [sigma_m](std::size_t, std::size_t) -> Eigen::Matrix2d {
      return Eigen::Vector2d(sigma_m * sigma_m, 1e-6).asDiagonal();
    };
  };
  const auto num = [&](double sigma_m) {
    return believed_closures(matches, track, spread_along_x(sigma_m), {}, {}).size();
  };
  EXPECT_EQ(num(2.5), matches.size()) << "9 m are more than 0.8 m and three spreads";
  EXPECT_EQ(num(3.0), 0U) << "a twin 9 m off is not out of reach";
}

TEST(ClosuresAnywhere, TooFewMatchesOfARoomTellNothing) {
  const AuditedTrack track = two_laps({9.0, -7.0});
  std::vector<AuditMatch> matches;
  for (const std::size_t room : {0U, 1U, 2U}) match_room(room, room, matches, 2);
  EXPECT_EQ(num_believed(matches, track, 15.0), 0U);
}

TEST(ClosuresAnywhere, RoomsThatLookTheSameCountOnce) {
  const AuditedTrack track = two_laps({9.0, -7.0});
  std::vector<AuditMatch> matches;
  for (const std::size_t room : {0U, 1U, 2U}) match_room(room, room, matches);
  ASSERT_EQ(num_believed(matches, track, 15.0), matches.size());
  // The first and the third room of the first lap are twins: three matches say so.
  for (const std::size_t i : {0U, 2U, 4U}) {
    EXPECT_EQ(num_believed(matches, track, 15.0), 12U) << "too few to say so";
    matches.push_back(match_of(i, 2 * kPerSide + i));
  }
  EXPECT_EQ(num_believed(matches, track, 15.0), 0U);
}

TEST(ClosuresAnywhere, ARoomThatLooksLikeTwoOthersIsAmbiguous) {
  const AuditedTrack track = two_laps({9.0, -7.0});
  std::vector<AuditMatch> matches;
  for (const std::size_t room : {0U, 1U, 2U, 3U}) match_room(room, room, matches);
  const std::size_t num_all = matches.size();
  ASSERT_EQ(num_believed(matches, track, 15.0), num_all);
  // The first room, seen again, looks like the third as well: the other three are left.
  match_room(2, 0, matches);
  const auto believed = believed_closures(matches, track, spread_of(15.0), {}, {});
  for (const std::size_t i : believed) EXPECT_NE(matches[i].pair.to, kPerLap) << i;
  ClosuresAnywhereParams params;
  params.max_rival_share = 100.0;
  EXPECT_GT(num_believed(matches, track, 15.0, params), believed.size())
      << "without the rule it is believed";
}

TEST(ClosuresAnywhere, WhatTurnsTheMapIsAnAlias) {
  const AuditedTrack track = two_laps({9.0, -7.0});
  std::vector<AuditMatch> matches;
  for (const std::size_t room : {0U, 1U, 2U}) {
    match_room(room, room, matches, 4, rad_from_deg(90.0));
  }
  EXPECT_EQ(num_believed(matches, track, 15.0), 0U);
}

TEST(ClosuresAnywhere, WhatTheMapKnowsIsLeftAlone) {
  const AuditedTrack track = two_laps({0.8, 0.0});
  std::vector<AuditMatch> matches;
  for (const std::size_t room : {0U, 1U, 2U}) match_room(room, room, matches);
  EXPECT_EQ(num_believed(matches, track, 0.1), 0U) << "the audit's contradictions";
}

}  // namespace setsquare::closures_anywhere_test
