// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "setsquare/report/match/figures/figures.hpp"
#include "setsquare/report/match/story/paper_match.hpp"
#include "setsquare/report/match/story/story.hpp"
#include "setsquare/report/match/story/verdict_rules.hpp"
#include "setsquare/scan/scan_to_points.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/rectangular_room.hpp"

namespace setsquare::match_story_test {

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

TEST(PaperScan, CurveProfilesAndThinningBelongTogether) {
  const PointSet points = points_from_scan(half_scan(kReference));
  EXPECT_EQ(points.size(), 361U);
  const PaperScan scan = paper_scan(points, {});
  EXPECT_LT(scan.thinned.size(), points.size());
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

TEST(PaperStory, ShowsTheFourOffsetsAndTheMatchersOwnAnswer) {
  const MatchStory story = tell_paper_match(half_scan(kReference), half_scan(kCurrent), {});
  ASSERT_TRUE(story.result.T_reference_current.has_value());
  ASSERT_EQ(story.proposals.size(), 4U);
  const auto& looked_at = std::get<PaperEvidence>(story.looked_at);
  ASSERT_EQ(looked_at.rotations.size(), 4U);
  const PaperRotation& answer = looked_at.rotations.front();
  EXPECT_EQ(looked_at.shifts.shift_m(first_peak(answer.along)), answer.shift_along_m);
  EXPECT_EQ(looked_at.shifts.shift_m(first_peak(answer.across)), answer.shift_across_m);
  EXPECT_THAT(story.proposals[0].T_reference_current,
              PoseNear(*story.result.T_reference_current, testing::PoseTolerance{}));
  EXPECT_THAT(story.proposals[0].fate, ::testing::HasSubstr("answer"));
  for (const StoryProposal& proposal : story.proposals) {
    EXPECT_EQ(proposal.measures.size(), story.measure_names.size());
    EXPECT_FALSE(proposal.fate.empty());
  }
}

TEST(DefaultStory, ShowsTheMatchersOwnAnswerAndTheLosers) {
  const MatchStory story = tell_default_match(half_scan(kReference), half_scan(kCurrent), {});
  ASSERT_TRUE(story.result.T_reference_current.has_value());
  ASSERT_GE(story.proposals.size(), 2U);
  EXPECT_THAT(story.proposals[0].T_reference_current,
              PoseNear(kReference.inverse() * kCurrent,
                       (testing::PoseTolerance{.translation_m = 0.02, .rotation_rad = 0.01})));
  const auto& looked_at = std::get<SurfaceEvidence>(story.looked_at);
  EXPECT_FALSE(looked_at.trace.rotations.empty());
  ASSERT_TRUE(story.T_proposed.has_value());
  EXPECT_EQ(*story.T_proposed, looked_at.trace.candidates.front().candidate.T_proposed);
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

/// Scans of rooms, of corridors and of nothing, near each other and far apart.
std::vector<std::pair<Scan, Scan>> odd_and_even_pairs() {
  std::vector<std::pair<Scan, Scan>> pairs;
  const Scan whole = scan_of_room(kReference, 9.0, 6.0, 360);
  pairs.emplace_back(half_scan(kReference), half_scan(kCurrent));
  pairs.emplace_back(whole, scan_of_room(kCurrent, 9.0, 6.0, 360));
  pairs.emplace_back(whole, scan_of_room({2.0, 2.0, 1.0}, 4.0, 4.0, 360));
  pairs.emplace_back(scan_of_room({20.0, 1.0, 0.1}, 40.0, 2.0, 360),
                     scan_of_room({21.0, 1.1, 0.0}, 40.0, 2.0, 360));
  Scan no_returns = whole;
  no_returns.ranges_m.assign(no_returns.num_beams(), 81.83);
  pairs.emplace_back(whole, no_returns);
  Scan few_returns = no_returns;
  for (std::size_t i = 0; i < 12; ++i) few_returns.ranges_m[i] = whole.ranges_m[i];
  pairs.emplace_back(whole, few_returns);
  return pairs;
}

TEST(VerdictRules, ComeToTheMatchersOwnVerdict) {
  std::set<MatchStatus> met;
  for (const auto& [reference, current] : odd_and_even_pairs()) {
    const MatchStory story = tell_default_match(reference, current, {});
    const auto& looked_at = std::get<SurfaceEvidence>(story.looked_at);
    EXPECT_EQ(to_string(status_of_rules(looked_at.rules)), to_string(story.result.status));
    met.insert(story.result.status);
  }
  EXPECT_GE(met.size(), 3U);
}

TEST(Story, ScansWithoutReturnsAreShownToo) {
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

}  // namespace setsquare::match_story_test
