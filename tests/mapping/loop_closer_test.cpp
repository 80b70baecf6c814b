// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/loops/loop_closer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "setsquare/core/error.hpp"
#include "tests/mapping/tracked_world.hpp"
#include "tests/support/pose_matchers.hpp"

namespace setsquare::loop_closer_test {

using testing::between;
using testing::PoseNear;
using testing::PoseTolerance;

/// A robot goes round a block of walls, and half of the way again.
class LoopCloserAroundABlock : public ::testing::Test {
 protected:
  LoopCloserAroundABlock()
      : truth_(testing::spaced(testing::drive(testing::way_around_the_block()))),
        track_(testing::track_in_world(testing::corridor_around_a_block(), truth_, 0.01)) {}

  /// The later keyframes of the closures accepted.
  static std::set<std::size_t> closing_stations(const LoopCloser& closer) {
    std::set<std::size_t> stations;
    for (const ComparedPlaces& places : closer.compared()) {
      if (is_accepted(places.verdict.reason)) stations.insert(places.to);
    }
    return stations;
  }

  std::vector<Pose2> truth_;
  KeyframeTrack track_;
};

TEST_F(LoopCloserAroundABlock, ClosesTheLoopOverADriftedTrack) {
  // A drift of 1 m by the end of the way: the rooms' walls must decide, not the track.
  std::vector<Pose2> drifted = truth_;
  for (std::size_t k = 0; k < drifted.size(); ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(drifted.size());
    drifted[k].x_m += 0.7 * share;
    drifted[k].y_m -= 0.7 * share;
  }
  LoopCloser closer;
  closer.extend(track_, track_.size(), drifted, 1);
  std::size_t num_accepted = 0;
  for (const ComparedPlaces& places : closer.compared()) {
    if (places.verdict.reason != ClosureReason::kStandsAlone) continue;
    ++num_accepted;
    EXPECT_THAT(places.T_from_to,
                PoseNear(between(truth_[places.from], truth_[places.to]),
                         PoseTolerance{.translation_m = 0.03, .rotation_rad = rad_from_deg(0.3)}))
        << places.from << " to " << places.to;
    EXPECT_LT(places.from, places.to);
  }
  EXPECT_GE(num_accepted, 8U);
}

TEST_F(LoopCloserAroundABlock, AnyNumberOfThreadsFindsTheSame) {
  LoopCloser alone;
  LoopCloser with_four;
  alone.extend(track_, track_.size(), truth_, 1);
  with_four.extend(track_, track_.size(), truth_, 4);
  ASSERT_EQ(alone.compared().size(), with_four.compared().size());
  ASSERT_FALSE(alone.compared().empty());
  for (std::size_t i = 0; i < alone.compared().size(); ++i) {
    const ComparedPlaces& a = alone.compared()[i];
    const ComparedPlaces& b = with_four.compared()[i];
    EXPECT_EQ(a.from, b.from);
    EXPECT_EQ(a.to, b.to);
    EXPECT_EQ(a.T_from_to, b.T_from_to);
    EXPECT_EQ(a.information, b.information);
    EXPECT_EQ(a.verdict.reason, b.verdict.reason);
  }
}

TEST_F(LoopCloserAroundABlock, GrowingTheTrackBitByBitClosesAtTheSamePlaces) {
  // Closures accepted on the way narrow the windows of those to come, so that a station may be
  // compared with another neighbour than if all are asked at once.
  LoopCloser at_once;
  at_once.extend(track_, track_.size(), truth_, 1);
  LoopCloser bit_by_bit;
  for (std::size_t end = 5; end < track_.size() + 7; end += 7) {
    bit_by_bit.extend(track_, std::min(end, track_.size()), truth_, 1);
  }
  EXPECT_FALSE(closing_stations(at_once).empty());
  EXPECT_EQ(closing_stations(bit_by_bit), closing_stations(at_once));
  const std::size_t num_compared = bit_by_bit.compared().size();
  bit_by_bit.extend(track_, track_.size(), truth_, 1);
  EXPECT_EQ(bit_by_bit.compared().size(), num_compared) << "nothing is compared twice";
}

TEST_F(LoopCloserAroundABlock, KeepsTheJointsThatItIsGiven) {
  ComparedPlaces joint;
  joint.from = 4;
  joint.to = 60;
  joint.verdict.reason = ClosureReason::kStandsAlone;
  LoopCloser closer;
  closer.add_joints(std::vector<ComparedPlaces>{joint});
  closer.extend(track_, track_.size(), truth_, 1);
  ASSERT_FALSE(closer.compared().empty());
  EXPECT_EQ(closer.compared().front().from, 4U);
  EXPECT_EQ(closer.compared().front().to, 60U);
}

TEST_F(LoopCloserAroundABlock, ComparesPiecesOnceAJointTiesThem) {
  // The second piece begins when the robot is back where it began.
  std::size_t second = truth_.size() / 2;
  while ((truth_[second].translation() - truth_[0].translation()).norm() > 0.3) ++second;
  ASSERT_LT(second + 20, truth_.size());
  for (std::size_t k = second; k < track_.size(); ++k) track_.pieces[k] = 1;
  const auto num_across = [&](const LoopCloser& closer) {
    return std::count_if(closer.compared().begin(), closer.compared().end(), [&](const auto& pair) {
      return (pair.from < second) != (pair.to < second);
    });
  };
  LoopCloser apart;
  apart.extend(track_, track_.size(), truth_, 1);
  EXPECT_EQ(num_across(apart), 0);

  ComparedPlaces joint;
  joint.from = 9;
  joint.to = second + 9;
  joint.verdict.reason = ClosureReason::kStandsAlone;
  LoopCloser at_once;
  LoopCloser bit_by_bit;  // Its joint waits until both its places are stations.
  for (LoopCloser* closer : {&at_once, &bit_by_bit}) {
    closer->add_joints(std::vector<ComparedPlaces>{joint});
    EXPECT_EQ(num_across(*closer), 1) << "the joint";
  }
  bit_by_bit.extend(track_, second + 5, truth_, 1);
  EXPECT_EQ(num_across(bit_by_bit), 1);
  for (LoopCloser* closer : {&at_once, &bit_by_bit}) {
    closer->extend(track_, track_.size(), truth_, 1);
    EXPECT_GT(num_across(*closer), 4);
  }
}

TEST(LoopCloser, FindsNothingOnATrackTooShortForAStation) {
  const std::vector<Pose2> poses(3);
  const KeyframeTrack track = testing::track_in_world(testing::l_shaped_room(), poses, 0.0);
  LoopCloser closer;
  closer.extend(track, track.size(), poses, 1);
  EXPECT_TRUE(closer.compared().empty());
}

TEST(LoopCloser, RefusesParametersThatAreNone) {
  LoopCloserParams no_spacing;
  no_spacing.station_spacing = 0;
  EXPECT_THROW(LoopCloser{no_spacing}, ParameterError);
  LoopCloserParams no_noise;
  no_noise.point_sigma_m = 0.0;
  EXPECT_THROW(LoopCloser{no_noise}, ParameterError);
}

}  // namespace setsquare::loop_closer_test
