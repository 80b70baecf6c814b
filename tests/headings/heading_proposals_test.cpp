// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "setsquare/core/angle.hpp"
#include "setsquare/headings/proposals.hpp"
#include "setsquare/scan/scan_to_points.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::heading_proposals_test {

using testing::scan_of_walls;
using testing::Wall;

constexpr double kConfidentMargin = 3.0;
const testing::Fan kAllAround{360, -kPi, kTwoPi / 360.0};

std::vector<HeadingProposal> proposals_of(const Scan& scan,
                                          double confident_margin = kConfidentMargin) {
  return heading_proposals(scan, {}, confident_margin);
}

double margin_of(const Scan& scan) {
  return square_directions(points_from_scan(scan), scan.bearing_step_rad).margin();
}

TEST(HeadingProposals, ASquareRoomProposesItsOwnDirection) {
  std::mt19937_64 generator = testing::make_generator();
  for (int run = 0; run < 20; ++run) {
    const Pose2 T_room_sensor{testing::uniform(generator, 1.0, 6.0),
                              testing::uniform(generator, 1.0, 5.0),
                              testing::uniform(generator, -kPi, kPi)};
    const Scan scan = scan_of_walls(
        testing::empty_rectangle(7.0, 6.0), T_room_sensor, kAllAround, 0.005, generator());
    const std::vector<HeadingProposal> proposals = proposals_of(scan);
    ASSERT_EQ(proposals.size(), 1U);
    const double miss_rad =
        wrap_to_period(proposals[0].heading_rad - T_room_sensor.theta_rad, 0.5 * kPi);
    EXPECT_NEAR(miss_rad, 0.0, rad_from_deg(0.3));
    EXPECT_EQ(proposals[0].confidence, 1.0);
    EXPECT_GT(proposals[0].sigma_rad, 0.0);
  }
}

TEST(HeadingProposals, ProposalsOfARoundRoomHaveLittleWeight) {
  // Its arcs are made of short straight pieces: some direction always has a little more of them.
  std::mt19937_64 generator = testing::make_generator();
  constexpr int kNumRuns = 40;
  double mean_confidence = 0.0;
  for (int run = 0; run < kNumRuns; ++run) {
    const Pose2 T_room_sensor{testing::uniform(generator, -1.0, 1.0),
                              testing::uniform(generator, -1.0, 1.0),
                              testing::uniform(generator, -kPi, kPi)};
    const Scan scan = scan_of_walls(
        testing::regular_polygon(360, 4.0), T_room_sensor, kAllAround, 0.005, generator());
    for (const HeadingProposal& proposal : proposals_of(scan)) {
      mean_confidence += proposal.confidence / kNumRuns;
    }
  }
  EXPECT_LT(mean_confidence, 0.2);
}

TEST(HeadingProposals, TooFewPointsProposeNothing) {
  Scan scan = scan_of_walls(testing::empty_rectangle(7.0, 6.0), {3.0, 3.0, 0.2}, kAllAround);
  scan.ranges_m.resize(2);
  EXPECT_TRUE(proposals_of(scan).empty());
  scan.ranges_m.clear();
  EXPECT_TRUE(proposals_of(scan).empty());
}

TEST(HeadingProposals, ConfidenceGrowsWithTheMargin) {
  // The longer the oblique screen, the smaller the margin of the room's own direction.
  constexpr double kLargeMargin = 30.0;
  double last_confidence = 1.0;
  for (const double length_m : {0.6, 1.2, 1.8, 2.4}) {
    std::vector<Wall> walls = testing::empty_rectangle(7.0, 6.0);
    walls.push_back({4.5, 1.5, 4.5 + length_m * std::cos(2.2), 1.5 + length_m * std::sin(2.2)});
    const Scan scan = scan_of_walls(walls, {2.0, 2.0, 0.1}, kAllAround, 0.005);
    const double margin = margin_of(scan);
    const std::vector<HeadingProposal> proposals = proposals_of(scan, kLargeMargin);
    ASSERT_EQ(proposals.size(), 1U);
    EXPECT_LT(proposals[0].confidence, last_confidence) << length_m << " m, margin " << margin;
    EXPECT_NEAR(proposals[0].confidence, (margin - 1.0) / (kLargeMargin - 1.0), 1e-12);
    EXPECT_EQ(proposals_of(scan, margin)[0].confidence, 1.0);
    last_confidence = proposals[0].confidence;
  }
}

}  // namespace setsquare::heading_proposals_test
