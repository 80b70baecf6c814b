// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <numeric>

#include "setsquare/report/match/figures/figures.hpp"
#include "setsquare/report/match/story/scan.hpp"
#include "setsquare/report/match/story/story.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/rectangular_room.hpp"

namespace setsquare {
namespace {

using testing::PoseNear;
using testing::scan_of_room;

const Pose2 kReference{3.0, 2.5, 0.2};
const Pose2 kCurrent{3.8, 2.1, 0.5};

/// Half of a room, as a scanner of 180 degrees sees it: no symmetry.
Scan half_scan(const Pose2& T_room_sensor) {
  Scan scan = scan_of_room(T_room_sensor, 9.0, 6.0, 720);
  scan.ranges_m.erase(scan.ranges_m.begin(), scan.ranges_m.begin() + 180);
  scan.ranges_m.resize(361);
  scan.first_bearing_rad = -0.5 * kPi;
  return scan;
}

TEST(StoryScan, CurveProfilesAndThinningBelongTogether) {
  const StoryScan scan = story_scan(half_scan(kReference), {});
  EXPECT_EQ(scan.points.size(), 361U);
  EXPECT_LT(scan.thinned.size(), scan.points.size());
  EXPECT_EQ(scan.moments.size(), 1800U);
  const auto highest = std::max_element(scan.moments.begin(), scan.moments.end());
  EXPECT_NEAR(*highest, scan.dominant.moment, 0.02 * *highest);  // bins may round differently
  for (const ProjectedProfile* profile : {&scan.along, &scan.across, &scan.off}) {
    EXPECT_EQ(profile->mass(), static_cast<std::int64_t>(scan.thinned.size()));
  }
  const auto peak = [](const ProjectedProfile& profile) {
    return *std::max_element(profile.counts.begin(), profile.counts.end());
  };
  EXPECT_GT(peak(scan.along), 3 * peak(scan.off));
}

TEST(StoryRotation, PeaksWhereThePoseSays) {
  const StoryScan reference = story_scan(half_scan(kReference), {});
  const StoryScan current = story_scan(half_scan(kCurrent), {});
  const Pose2 T_reference_current = kReference.inverse() * kCurrent;
  const ShiftSearch search = {.max_shift_m = 2.5, .step_m = 0.02};
  const StoryRotation rotation = story_rotation(reference, current, T_reference_current, search);
  const auto peak_m = [&](const std::vector<std::int32_t>& correlation) {
    return search.shift_m(first_peak(correlation));
  };
  EXPECT_NEAR(peak_m(rotation.along), rotation.shift_along_m, 0.05);
  EXPECT_NEAR(peak_m(rotation.across), rotation.shift_across_m, 0.05);
}

TEST(PaperStory, TellsTheFourOffsetsAndTheMatchersOwnAnswer) {
  const MatchStory story = tell_paper_match(half_scan(kReference), half_scan(kCurrent), {});
  ASSERT_TRUE(story.result.T_reference_current.has_value());
  ASSERT_EQ(story.proposals.size(), 4U);
  ASSERT_EQ(story.rotations.size(), 4U);
  EXPECT_THAT(story.proposals[0].T_reference_current,
              PoseNear(*story.result.T_reference_current, testing::PoseTolerance{}));
  EXPECT_THAT(story.proposals[0].fate, ::testing::HasSubstr("answer"));
  for (const StoryProposal& proposal : story.proposals) {
    EXPECT_EQ(proposal.measures.size(), story.measure_names.size());
    EXPECT_FALSE(proposal.fate.empty());
  }
}

TEST(DefaultStory, TellsTheMatchersOwnAnswerAndTheLosers) {
  const MatchStory story = tell_default_match(half_scan(kReference), half_scan(kCurrent), {});
  ASSERT_TRUE(story.result.T_reference_current.has_value());
  ASSERT_GE(story.proposals.size(), 2U);
  EXPECT_THAT(story.proposals[0].T_reference_current,
              PoseNear(kReference.inverse() * kCurrent,
                       (testing::PoseTolerance{.translation_m = 0.02, .rotation_rad = 0.01})));
  ASSERT_FALSE(story.rotations.empty());
  EXPECT_EQ(story.rotations[0].rotation_rad, story.result.T_reference_current->theta_rad);
  for (const StoryProposal& proposal : story.proposals) {
    EXPECT_EQ(proposal.measures.size(), story.measure_names.size());
    EXPECT_FALSE(proposal.fate.empty());
  }
  const StoryProposal* other = best_other_proposal(story);
  ASSERT_NE(other, nullptr);
  if (story.result.runner_up) {
    EXPECT_THAT(other->T_reference_current,
                PoseNear(story.result.runner_up->T_reference_current,
                         (testing::PoseTolerance{.translation_m = 0.02, .rotation_rad = 0.01})));
  }
}

TEST(Story, ScansWithoutReturnsAreToldToo) {
  Scan empty = half_scan(kReference);
  for (double& range_m : empty.ranges_m) range_m = 81.83;
  for (const MatchStory& story : {tell_paper_match(empty, half_scan(kCurrent), {}),
                                  tell_default_match(half_scan(kReference), empty, {})}) {
    EXPECT_EQ(story.result.status, MatchStatus::kTooFewPoints);
    EXPECT_TRUE(story.proposals.empty());
    EXPECT_FALSE(story.evidence.empty());
    EXPECT_EQ(best_other_proposal(story), nullptr);
  }
}

}  // namespace
}  // namespace setsquare
