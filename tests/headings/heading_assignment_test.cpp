// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/headings/fusion.hpp"

namespace setsquare::heading_assignment_test {

constexpr double kPeriod_rad = 0.5 * kPi;
constexpr double kGate_rad = rad_from_deg(4.0);

/// Two frames 30 deg apart; a keyframe that has drifted by a full turn and a bit.
HeadingFrames two_frames(double share) {
  return {.frames = {{.offset_rad = 0.0}, {.offset_rad = rad_from_deg(30.0)}},
          .drift_rad = {kTwoPi + 0.1},
          .step_sigma_rad = {0.01},
          .share = share};
}

HeadingEvidence keyframe_with(const std::vector<double>& offsets_rad) {
  HeadingEvidence keyframe{.tracked_heading_rad = 1.0, .step_sigma_rad = 0.01, .proposals = {}};
  for (const double offset_rad : offsets_rad) {
    keyframe.proposals.push_back({1.0 + offset_rad, 0.03, 0.5});
  }
  return keyframe;
}

TEST(HeadingAssignment, AProposalGoesToTheFrameThatItFits) {
  const double near_second_rad = 0.1 + rad_from_deg(31.0 - 90.0);
  const auto measurements = assign_heading_proposals(
      {keyframe_with({near_second_rad, 0.12})}, two_frames(1.0), kPeriod_rad, kGate_rad, 0.04);
  ASSERT_EQ(measurements.size(), 2U);
  EXPECT_EQ(measurements[0].frame, 1U);
  EXPECT_NEAR(measurements[0].offset_rad, kTwoPi + 0.1 + rad_from_deg(31.0), 1e-12)
      << "unwrapped near the drift";
  EXPECT_EQ(measurements[1].frame, 0U);
  EXPECT_NEAR(measurements[1].offset_rad, kTwoPi + 0.12, 1e-12);
  EXPECT_NEAR(measurements[1].information, 0.5 / (0.05 * 0.05), 1e-9);
}

TEST(HeadingAssignment, WhatFitsNoFrameIsNone) {
  EXPECT_TRUE(assign_heading_proposals({keyframe_with({0.1 + rad_from_deg(15.0)})},
                                       two_frames(1.0),
                                       kPeriod_rad,
                                       kGate_rad,
                                       0.04)
                  .empty());
}

TEST(HeadingAssignment, WhereLittleFitsTheRestHasLessWeight) {
  const auto all = assign_heading_proposals(
      {keyframe_with({0.1})}, two_frames(1.0), kPeriod_rad, kGate_rad, 0.04);
  const auto half = assign_heading_proposals(
      {keyframe_with({0.1})}, two_frames(0.5), kPeriod_rad, kGate_rad, 0.04);
  EXPECT_NEAR(half.at(0).information, 0.25 * all.at(0).information, 1e-9);
}

}  // namespace setsquare::heading_assignment_test
