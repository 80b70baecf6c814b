// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/headings/frames.hpp"
#include "setsquare/headings/proposals.hpp"
#include "tests/headings/simulated_headings.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::heading_frames_test {

using testing::HeadingSimulation;
using testing::make_generator;
using testing::simulate_headings;
using testing::SimulatedHeadings;

HeadingFrames find(const SimulatedHeadings& simulated) {
  return find_heading_frames(simulated.evidence, trace_headings(simulated.evidence));
}

/// Largest distance of the rough drift from the true one, modulo a quarter turn and apart from what
/// all keyframes have in common.
double worst_miss_rad(const SimulatedHeadings& simulated, const HeadingFrames& found) {
  const auto miss_rad = [&](std::size_t k) {
    return simulated.evidence[k].tracked_heading_rad + found.drift_rad[k] -
           simulated.heading_rad[k];
  };
  double worst_rad = 0.0;
  for (std::size_t k = 0; k < found.drift_rad.size(); ++k) {
    worst_rad = std::max(worst_rad, std::abs(wrap_to_period(miss_rad(k) - miss_rad(0), 0.5 * kPi)));
  }
  return worst_rad;
}

TEST(HeadingFrames, ABuildingOfRightAnglesHasOne) {
  auto generator = make_generator();
  const auto simulated = simulate_headings({.num_keyframes = 500,
                                            .drift_per_step_rad = rad_from_deg(0.1),
                                            .measurement_noise_rad = rad_from_deg(0.3),
                                            .outlier_share = 0.2},
                                           generator);
  const HeadingFrames found = find(simulated);
  ASSERT_EQ(found.frames.size(), 1U);
  EXPECT_GT(found.frames[0].support, 350.0);
  EXPECT_LT(worst_miss_rad(simulated, found), rad_from_deg(2.0));
}

TEST(HeadingFrames, AWingSeenAgainIsTheSameFrame) {
  auto generator = make_generator();
  const auto simulated =
      simulate_headings({.num_keyframes = 1000,
                         .drift_per_step_rad = rad_from_deg(0.03),
                         .measurement_noise_rad = rad_from_deg(0.3),
                         .outlier_share = 0.2,
                         .wing_offset_rad = {0.0, rad_from_deg(30.0), 0.0, rad_from_deg(-25.0)}},
                        generator);
  const HeadingFrames found = find(simulated);
  ASSERT_EQ(found.frames.size(), 3U) << "ten visits, three frames";
  EXPECT_EQ(found.frames[0].offset_rad, 0.0);
  std::vector<double> offsets_rad = {found.frames[1].offset_rad, found.frames[2].offset_rad};
  std::sort(offsets_rad.begin(), offsets_rad.end());
  EXPECT_NEAR(offsets_rad[0], rad_from_deg(-25.0), rad_from_deg(1.5));
  EXPECT_NEAR(offsets_rad[1], rad_from_deg(30.0), rad_from_deg(1.5));
  EXPECT_LT(worst_miss_rad(simulated, found), rad_from_deg(2.5));
}

/// Each keyframe once for each of two scanners that stand at its place.
SimulatedHeadings seen_by_two(const SimulatedHeadings& simulated) {
  SimulatedHeadings twice;
  for (std::size_t k = 0; k < simulated.evidence.size(); ++k) {
    for (int scanner = 0; scanner < 2; ++scanner) {
      twice.heading_rad.push_back(simulated.heading_rad[k]);
      twice.evidence.push_back(simulated.evidence[k]);
      share_place(0.5, twice.evidence.back());
    }
  }
  return twice;
}

/// Most walls are outliers here, so that a frame's support is little more than it must be.
TEST(HeadingFrames, TwoScannersAtAPlaceAreOneKeyframe) {
  auto generator = make_generator();
  const auto simulated = simulate_headings({.num_keyframes = 400,
                                            .measurement_noise_rad = rad_from_deg(0.3),
                                            .outlier_share = 0.6,
                                            .wing_offset_rad = {0.0, rad_from_deg(30.0)}},
                                           generator);
  const HeadingFrames once = find(simulated);
  const HeadingFrames twice = find(seen_by_two(simulated));
  ASSERT_EQ(once.frames.size(), 2U);
  ASSERT_EQ(twice.frames.size(), 2U);
  for (std::size_t f = 0; f < 2; ++f) {
    EXPECT_NEAR(twice.frames[f].offset_rad, once.frames[f].offset_rad, rad_from_deg(0.6));
    EXPECT_NEAR(twice.frames[f].support, once.frames[f].support, 1.0);
  }
}

TEST(HeadingFrames, AWallThatTurnsGraduallyIsNone) {
  auto generator = make_generator();
  auto simulated = simulate_headings({.num_keyframes = 300}, generator);
  for (std::size_t k = 100; k < 140; ++k) {  // A curved corridor between two straight ones.
    simulated.evidence[k].proposals.front().heading_rad +=
        rad_from_deg(90.0 / 40.0) * static_cast<double>(k - 99);
  }
  const HeadingFrames found = find(simulated);
  EXPECT_EQ(found.frames.size(), 1U);
  EXPECT_LT(worst_miss_rad(simulated, found), rad_from_deg(0.6));
}

TEST(HeadingFrames, ASmallJumpThatStaysIsASlip) {
  auto generator = make_generator();
  auto simulated = simulate_headings({.num_keyframes = 200}, generator);
  for (std::size_t k = 80; k < 200; ++k) {
    simulated.evidence[k].tracked_heading_rad -= rad_from_deg(6.0);
  }
  const HeadingFrames found = find(simulated);
  ASSERT_EQ(found.frames.size(), 1U);
  EXPECT_LT(worst_miss_rad(simulated, found), rad_from_deg(0.6));
  EXPECT_NEAR(found.step_sigma_rad[80], rad_from_deg(6.0), rad_from_deg(0.6));
  EXPECT_EQ(found.step_sigma_rad[81], simulated.evidence[81].step_sigma_rad);
}

TEST(HeadingFrames, ASmallJumpThatIsUndoneIsAWallAskew) {
  auto generator = make_generator();
  auto simulated = simulate_headings({.num_keyframes = 200}, generator);
  for (std::size_t k = 80; k < 110; ++k) {
    simulated.evidence[k].proposals.front().heading_rad += rad_from_deg(6.0);
  }
  const HeadingFrames found = find(simulated);
  ASSERT_EQ(found.frames.size(), 2U);
  EXPECT_NEAR(found.frames[1].offset_rad, rad_from_deg(6.0), rad_from_deg(0.6));
  EXPECT_LT(worst_miss_rad(simulated, found), rad_from_deg(0.6));
}

TEST(HeadingFrames, TheShareExplainedSeparatesStraightWallsFromRoundOnes) {
  auto generator = make_generator();
  const auto straight = simulate_headings({.num_keyframes = 300, .outlier_share = 0.1}, generator);
  const auto round = simulate_headings({.num_keyframes = 300, .outlier_share = 1.0}, generator);
  EXPECT_GT(find(straight).share, 0.85);
  EXPECT_LT(find(round).share, 0.3);
}

TEST(HeadingFrames, ChanceMakesNeitherAFrameNorASlip) {
  auto generator = make_generator();
  const auto round = simulate_headings({.num_keyframes = 300, .outlier_share = 1.0}, generator);
  const HeadingFrames found = find(round);
  EXPECT_EQ(found.frames.size(), 1U);
  for (std::size_t k = 0; k < 300; ++k) {
    EXPECT_EQ(found.step_sigma_rad[k], round.evidence[k].step_sigma_rad) << k;
  }
}

TEST(HeadingFrames, AShortLogHasAFrameToo) {
  auto generator = make_generator();
  const auto simulated = simulate_headings({.num_keyframes = 3}, generator);
  const HeadingFrames found = find(simulated);
  ASSERT_EQ(found.frames.size(), 1U);
  EXPECT_NEAR(wrap_to_period(simulated.evidence[1].tracked_heading_rad + found.drift_rad[1] -
                                 simulated.heading_rad[1],
                             0.5 * kPi),
              0.0,
              rad_from_deg(0.6));
}

TEST(HeadingFrames, WithoutKeyframesThereIsTheMainFrameAlone) {
  const HeadingFrames found = find_heading_frames({}, trace_headings({}));
  EXPECT_EQ(found.frames.size(), 1U);
  EXPECT_TRUE(found.drift_rad.empty());
}

TEST(HeadingFrames, NamesABadParameter) {
  EXPECT_THROW(HeadingFramesParams{.min_separation_rad = 0.0}.validate(), ParameterError);
  EXPECT_THROW(HeadingFramesParams{.min_support = -1.0}.validate(), ParameterError);
  EXPECT_NO_THROW(HeadingFramesParams{}.validate());
}

}  // namespace setsquare::heading_frames_test
