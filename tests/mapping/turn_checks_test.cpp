// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Tracks whose rotation slipped at a step, with walls that tell that something turned, and matches
// of scans that tell what.
#include "setsquare/mapping/turn_checks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/headings/proposals.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "tests/mapping/tracked_world.hpp"

namespace setsquare::turn_checks_test {

/// Keyframes around the block and the evidence of their walls.
struct Track {
  std::vector<Pose2> truth;
  KeyframeTrack track;
  std::vector<HeadingEvidence> evidence;
};

/// Everything from keyframe `slips_at[i].first` on is tracked turned by `.second` about it.
Track track_with_slips(const std::vector<std::pair<std::size_t, double>>& slips_at,
                       const testing::Fan& fan = testing::kAllAround,
                       std::size_t first_seed = 1) {
  Track made;
  const auto walls = testing::corridor_around_a_block();
  made.truth = testing::spaced(testing::drive(testing::way_around_the_block()));
  made.track = testing::track_in_world(walls, made.truth, 0.01, fan, first_seed);
  for (const auto& [at, slip_rad] : slips_at) {
    const Pose2 pivot = made.track.keyframes[at]->T_odom_sensor;
    const Pose2 T_odom_slipped = pivot * Pose2{0.0, 0.0, slip_rad} * pivot.inverse();
    for (std::size_t k = at; k < made.track.size(); ++k) {
      const Keyframe& keyframe = *made.track.keyframes[k];
      made.track.keyframes[k] =
          testing::make_keyframe(*keyframe.scan, T_odom_slipped * keyframe.T_odom_sensor, k);
    }
  }
  const MapperParams params;
  for (std::size_t k = 0; k < made.track.size(); ++k) {
    const Keyframe& keyframe = *made.track.keyframes[k];
    made.evidence.push_back({.tracked_heading_rad = keyframe.T_odom_sensor.theta_rad,
                             .step_sigma_rad = std::sqrt(made.track.motions[k].rotation_rad2),
                             .proposals = heading_proposals(
                                 *keyframe.scan, params.direction, params.confident_margin)});
  }
  return made;
}

/// The largest error of a fused heading, apart from what all have in common with the first.
double worst_rad(const Track& track, const FusedHeadings& fused) {
  double worst_rad = 0.0;
  for (std::size_t k = 0; k < track.truth.size(); ++k) {
    const double off_rad = fused.heading_rad[k] - track.truth[k].theta_rad - fused.heading_rad[0] +
                           track.truth[0].theta_rad;
    worst_rad = std::max(worst_rad, std::abs(wrap_to_pi(off_rad)));
  }
  return worst_rad;
}

TEST(TurnChecks, WhereWallsAndTrackingAgreeNothingIsDoubted) {
  const Track track = track_with_slips({});
  const FusedHeadings fused = TurnChecks().fuse(track.track, track.evidence, {});
  EXPECT_TRUE(fused.doubted.empty());
  EXPECT_LT(worst_rad(track, fused), rad_from_deg(0.5));
}

TEST(TurnChecks, ASlipIsMeasuredByMatches) {
  for (const double slip_deg : {-21.0, -8.0, 5.0, 13.0, 30.0}) {
    const Track track = track_with_slips({{30, rad_from_deg(slip_deg)}});
    const FusedHeadings fused = TurnChecks().fuse(track.track, track.evidence, {});
    EXPECT_LT(worst_rad(track, fused), rad_from_deg(1.0)) << slip_deg;
    EXPECT_EQ(fused.frames.size(), 1U) << slip_deg;
  }
}

TEST(TurnChecks, ALargeSlipIsTakenForAWingWithoutThem) {
  const Track track = track_with_slips({{30, rad_from_deg(21.0)}});
  const FusedHeadings fused = TurnChecks({.max_rounds = 0}).fuse(track.track, track.evidence, {});
  EXPECT_GT(worst_rad(track, fused), rad_from_deg(10.0));
}

TEST(TurnChecks, ASlipThatIsSoonUndoneIsFoundBothTimes) {
  const Track track = track_with_slips({{30, rad_from_deg(5.0)}, {33, rad_from_deg(-5.0)}});
  const FusedHeadings fused = TurnChecks().fuse(track.track, track.evidence, {});
  EXPECT_LT(worst_rad(track, fused), rad_from_deg(1.0));
}

TEST(TurnChecks, WhatIsKnownOfAStepIsKept) {
  const Track track = track_with_slips({{30, rad_from_deg(8.0)}});
  TurnChecks checks;
  const FusedHeadings once = checks.fuse(track.track, track.evidence, {});
  const FusedHeadings again = checks.fuse(track.track, track.evidence, {});
  EXPECT_EQ(once.heading_rad, again.heading_rad);
}

TEST(TurnChecks, ATrackShorterThanTheLongestHopIsChecked) {
  Track track = track_with_slips({{3, rad_from_deg(8.0)}});
  const auto shorten = [](auto& items) { items.erase(items.begin() + 5, items.end()); };
  shorten(track.truth);
  shorten(track.track.keyframes);
  shorten(track.track.motions);
  shorten(track.track.stretches);
  shorten(track.track.pieces);
  shorten(track.evidence);
  for (HeadingEvidence& keyframe : track.evidence) {
    if (!keyframe.proposals.empty()) keyframe.proposals.front().confidence = 1.0;
  }
  // Never enough matches, so that every hop is tried.
  const FusedHeadings fused =
      TurnChecks({.min_slip_matches = 100}).fuse(track.track, track.evidence, {});
  EXPECT_EQ(fused.heading_rad.size(), 5U);
  EXPECT_FALSE(fused.doubted.empty());
}

constexpr std::size_t kNumKeyframes = 8;

/// A drive along a corridor with a few flat pilasters, exactly tracked, of which somebody says that
/// the walls turn by 20 deg halfway.
Track corridor_whose_walls_seem_to_turn() {
  const std::vector<testing::Wall> walls = {{0.0, 0.0, 12.0, 0.0},
                                            {0.0, 1.5, 12.0, 1.5},
                                            {8.0, 0.0, 8.0, 0.1},
                                            {8.0, 0.1, 8.6, 0.1},
                                            {8.6, 0.1, 8.6, 0.0},
                                            {5.3, 1.5, 5.3, 1.4},
                                            {5.3, 1.4, 5.9, 1.4},
                                            {5.9, 1.4, 5.9, 1.5},
                                            {9.7, 0.0, 9.7, 0.1},
                                            {9.7, 0.1, 10.3, 0.1},
                                            {10.3, 0.1, 10.3, 0.0}};
  Track made;
  for (std::size_t k = 0; k < kNumKeyframes; ++k) {
    made.truth.push_back({2.0 + 0.4 * static_cast<double>(k), 0.7, 0.0});
  }
  made.track = testing::track_in_world(walls, made.truth, 0.01);
  for (std::size_t k = 0; k < kNumKeyframes; ++k) {
    const double walls_rad = k < kNumKeyframes / 2 ? 0.0 : rad_from_deg(20.0);
    made.evidence.push_back(
        {.step_sigma_rad = 0.002,
         .proposals = {
             {.heading_rad = walls_rad, .sigma_rad = rad_from_deg(0.2), .confidence = 1.0}}});
  }
  return made;
}

// Matches in a bare corridor leave the way along it open, not the rotation.
TEST(TurnChecks, DegenerateMatchesConfirmARotation) {
  const Track track = corridor_whose_walls_seem_to_turn();
  constexpr double kNever = 2.0;
  const TurnChecks without({.min_degenerate_probability = kNever});
  EXPECT_FALSE(TurnChecks(without).fuse(track.track, track.evidence, {}).doubted.empty());
  EXPECT_TRUE(TurnChecks().fuse(track.track, track.evidence, {}).doubted.empty());
}

TEST(TurnChecks, DegenerateMatchesMeasureNoSlip) {
  Track track = corridor_whose_walls_seem_to_turn();
  for (std::size_t k = kNumKeyframes / 2; k < kNumKeyframes; ++k) {
    const Keyframe& keyframe = *track.track.keyframes[k];
    Pose2 T_odom_slipped = keyframe.T_odom_sensor;
    T_odom_slipped.theta_rad += rad_from_deg(20.0);
    track.track.keyframes[k] = testing::make_keyframe(*keyframe.scan, T_odom_slipped, k);
    track.evidence[k].tracked_heading_rad = T_odom_slipped.theta_rad;
    track.evidence[k].proposals.front().heading_rad = 0.0;
  }
  EXPECT_FALSE(TurnChecks().fuse(track.track, track.evidence, {}).doubted.empty());
}

// Sixteen beams hit a corner here and a wall there: their walls turn where nothing turns, and a few
// returns lie on something however two scans are laid onto each other.
TEST(TurnChecks, ScansOfFewBeamsConfirmNothing) {
  constexpr testing::Fan kFew{16, -kPi, kTwoPi / 16.0};
  constexpr std::size_t kSeedWithDoubt = 1001;
  const Track track = track_with_slips({}, kFew, kSeedWithDoubt);
  EXPECT_FALSE(TurnChecks().fuse(track.track, track.evidence, {}).doubted.empty());
  EXPECT_TRUE(TurnChecks({.min_beams = 0}).fuse(track.track, track.evidence, {}).doubted.empty());
}

TEST(TurnChecks, TurnsOfScansOfFewBeamsAreNotHeldForWings) {
  const Track track = track_with_slips({{30, rad_from_deg(8.0)}});
  const auto headings = [&](double unlikely_slip_sigmas, std::size_t min_beams) {
    const TurnCheckParams params{
        .unlikely_slip_sigmas = unlikely_slip_sigmas, .max_rounds = 0, .min_beams = min_beams};
    return TurnChecks(params).fuse(track.track, track.evidence, {}).heading_rad;
  };
  constexpr double kNever = 1e6;
  constexpr double kAlways = 1e-6;
  constexpr std::size_t kMoreThanThereAre = 100'000;
  EXPECT_EQ(headings(kAlways, kMoreThanThereAre), headings(kNever, kMoreThanThereAre));
  EXPECT_NE(headings(kAlways, 0), headings(kNever, 0));
}

TEST(TurnChecks, RefuseWrongParameters) {
  EXPECT_THROW(TurnCheckParams{.agreeing_rad = 0.0}.validate(), ParameterError);
  EXPECT_THROW(TurnCheckParams{.longest_hop = 0}.validate(), ParameterError);
  EXPECT_THROW(TurnCheckParams{.slip_sigma_rad = -1.0}.validate(), ParameterError);
  EXPECT_NO_THROW(TurnCheckParams{}.validate());
}

}  // namespace setsquare::turn_checks_test
