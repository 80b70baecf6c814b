// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/track_certainty.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "setsquare/mapping/mapper.hpp"
#include "tests/support/simulated_drive.hpp"

namespace setsquare::track_certainty_test {

using testing::drive;
using testing::scans_on_drive;
using testing::Wall;

constexpr double kStepSigma_m = 0.01;

/// Two rooms, 30 m apart, and a corridor between them that shows nothing along its middle: the
/// scanner sees 8 m far.
std::vector<Wall> rooms_and_corridor() {
  return {{0.0, 0.0, 4.0, 0.0},
          {4.0, 0.0, 4.0, 1.0},
          {4.0, 1.0, 34.0, 1.0},
          {34.0, 1.0, 34.0, 0.0},
          {34.0, 0.0, 38.0, 0.0},
          {38.0, 0.0, 38.0, 4.0},
          {38.0, 4.0, 34.0, 4.0},
          {34.0, 4.0, 34.0, 3.0},
          {34.0, 3.0, 4.0, 3.0},
          {4.0, 3.0, 4.0, 4.0},
          {4.0, 4.0, 0.0, 4.0},
          {0.0, 4.0, 0.0, 0.0}};
}

/// A robot drives from room to room; what is farther than 8 m gives no return.
Map map_of_corridor(bool has_odometry) {
  const std::vector<Pose2> truth = drive({{1.0, 2.0}, {37.0, 2.0}});
  std::vector<Scan> scans = scans_on_drive(rooms_and_corridor(), truth, 0.005);
  Mapper mapper;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    for (double& range_m : scans[i].ranges_m) {
      if (range_m > 8.0) range_m = std::numeric_limits<double>::infinity();
    }
    mapper.add(scans[i], has_odometry ? std::optional(truth[i]) : std::nullopt);
  }
  return mapper.finish();
}

TEST(TrackCertainty, ABareCorridorIsReportedWithItsDirectionAndItsHeadingIsRight) {
  const Map track = map_of_corridor(false);
  const std::vector<OpenStretch> stretches = open_stretches(track);
  ASSERT_FALSE(stretches.empty());
  double way_m = 0.0;
  for (const OpenStretch& stretch : stretches) {
    way_m += stretch.way_m;
    EXPECT_FALSE(stretch.has_odometry);
    EXPECT_NEAR(wrap_to_period(stretch.direction_rad, kPi), 0.0, rad_from_deg(2.0));
    // A share of the way, not millimetres: no scan has seen it.
    EXPECT_GT(stretch.length_sigma_m, 0.02 * stretch.way_m);
  }
  EXPECT_GT(way_m, 8.0) << "from where neither room is seen until the other one is";
  for (const MappedScan& scan : track.scans) {
    EXPECT_NEAR(scan.T_map_sensor.theta_rad, 0.0, rad_from_deg(0.5));
  }
}

TEST(TrackCertainty, OdometryDeterminesTheLength) {
  const auto worst_sigma_m = [](const Map& track) {
    double worst_m = 0.0;
    for (const OpenStretch& stretch : open_stretches(track)) {
      worst_m = std::max(worst_m, stretch.length_sigma_m);
    }
    return worst_m;
  };
  const Map with = map_of_corridor(true);
  EXPECT_LT(worst_sigma_m(with), 0.5 * worst_sigma_m(map_of_corridor(false)));
  for (const OpenStretch& stretch : open_stretches(with)) EXPECT_TRUE(stretch.has_odometry);
}

TEST(TrackCertainty, PositionsGrowUncertainAlongTheCorridor) {
  const Map track = map_of_corridor(false);
  const std::vector<double> sigmas_m = position_sigmas_m(track);
  ASSERT_EQ(sigmas_m.size(), track.scans.size());
  EXPECT_LT(sigmas_m.front(), 0.01);
  EXPECT_GT(sigmas_m.back(), 0.1);
  for (std::size_t i = 1; i < sigmas_m.size(); ++i) {
    EXPECT_GE(sigmas_m[i], sigmas_m[i - 1] - 1e-3) << "no loop is closed";
  }
}

// Few nodes in a long track: without those of the open stretch the spread would rise in a straight
// line from the first to the last, in the room and in the corridor.
TEST(TrackCertainty, AlongAnOpenStretchItIsAskedWhereItRises) {
  const Map track = map_of_corridor(false);
  const std::vector<double> by_all_m = position_sigmas_m(track, track.keyframes.size());
  const std::vector<double> by_few_m = position_sigmas_m(track, 2);
  for (std::size_t i = 0; i < by_all_m.size(); ++i) {
    EXPECT_NEAR(by_few_m[i], by_all_m[i], 0.25 * by_all_m[i] + 0.02) << i;
  }
}

TEST(TrackCertainty, OfPiecesThatAreNotJoinedNothingIsKnown) {
  Map track = map_of_corridor(false);
  const std::size_t middle = track.scans.size() / 2;
  track.pieces = {{0, middle, true}, {middle, track.scans.size() - middle, false}};
  const std::vector<double> sigmas_m = position_sigmas_m(track);
  EXPECT_TRUE(std::isfinite(sigmas_m[middle - 1]));
  EXPECT_TRUE(std::isinf(sigmas_m[middle]));
  EXPECT_TRUE(std::isinf(sigmas_m.back()));
}

/// A graph whose answer is known: every step along x is as certain as the next one, headings are
/// exact, and each step to the next piece is off by `gap_sigma_m`. Each keyframe has two scans.
Map chain_of_pieces(const std::vector<TrackPiece>& pieces, double gap_sigma_m) {
  Map track;
  track.pieces = pieces;
  for (const TrackPiece& piece : pieces) {
    for (std::size_t scan = piece.first_scan; scan < piece.first_scan + piece.num_scans;
         scan += 2) {
      const std::size_t node = track.keyframes.size();
      track.keyframes.push_back(scan);
      track.graph.T_map_node.push_back({static_cast<double>(node), 0.0, 0.0});
      if (node == 0) continue;
      const double sigma_m = scan == piece.first_scan ? gap_sigma_m : kStepSigma_m;
      Constraint step{.from = node - 1, .to = node, .T_from_to = {1.0, 0.0, 0.0}};
      step.information.topLeftCorner<2, 2>() /= sigma_m * sigma_m;
      step.information(2, 2) = 1e14;
      track.graph.constraints.push_back(step);
    }
  }
  track.scans.resize(pieces.back().first_scan + pieces.back().num_scans);
  return track;
}

TEST(TrackCertainty, BoundsTheNumberOfNodesAndReachesTheLastOne) {
  for (const std::size_t num_nodes : {2U, 3U, 48U, 49U, 95U, 96U, 300U}) {
    const Map track = chain_of_pieces({{0, 2 * num_nodes, true}}, 0.0);
    for (const std::size_t max_num_nodes : {2U, 7U, 48U}) {
      const std::vector<double> sigmas_m = position_sigmas_m(track, max_num_nodes);
      // The sigmas, a root along the chain, bend where a node was asked.
      std::size_t num_asked = 2;
      for (std::size_t k = 1; k + 1 < num_nodes; ++k) {
        const double bend_m = sigmas_m[2 * k + 2] - 2.0 * sigmas_m[2 * k] + sigmas_m[2 * k - 2];
        num_asked += bend_m < -1e-9;
      }
      EXPECT_EQ(num_asked, std::min(num_nodes, max_num_nodes)) << num_nodes;
      const double last_m = kStepSigma_m * std::sqrt(static_cast<double>(num_nodes - 1));
      EXPECT_NEAR(sigmas_m.front(), 0.0, 1e-9);
      EXPECT_NEAR(sigmas_m.back(), last_m, 1e-3 * last_m) << num_nodes;
    }
  }
}

TEST(TrackCertainty, BetweenPiecesItJumps) {
  constexpr double kGapSigma_m = 2.0;
  const Map track = chain_of_pieces({{0, 150, true}, {150, 40, true}, {190, 2, true}}, kGapSigma_m);
  for (const std::size_t max_num_nodes : {2U, 6U, 48U, 1000U}) {
    const std::vector<double> sigmas_m = position_sigmas_m(track, max_num_nodes);
    EXPECT_NEAR(sigmas_m[149], kStepSigma_m * std::sqrt(74.0), 1e-4);
    EXPECT_NEAR(sigmas_m[150], std::hypot(sigmas_m[149], kGapSigma_m), 1e-3);
    EXPECT_NEAR(sigmas_m[189], std::hypot(sigmas_m[150], kStepSigma_m * std::sqrt(19.0)), 1e-3);
    EXPECT_NEAR(sigmas_m[190], std::hypot(sigmas_m[189], kGapSigma_m), 1e-3);
    EXPECT_EQ(sigmas_m[190], sigmas_m[191]);
  }
}

TEST(TrackCertainty, CountsFromTheFirstKeyframeThatIsJoined) {
  const Map track = chain_of_pieces({{0, 20, false}, {20, 200, true}, {220, 10, false}}, 200.0);
  const std::vector<double> sigmas_m = position_sigmas_m(track);
  EXPECT_TRUE(std::isinf(sigmas_m[19]));
  EXPECT_NEAR(sigmas_m[20], 0.0, 1e-9);
  EXPECT_NEAR(sigmas_m[219], kStepSigma_m * std::sqrt(99.0), 1e-4);
  EXPECT_TRUE(std::isinf(sigmas_m[220]));
}

TEST(TrackCertainty, AStretchEndsWithItsPiece) {
  Map track = chain_of_pieces({{0, 100, true}, {100, 60, true}}, 200.0);
  for (std::size_t scan = 0; scan < track.scans.size(); ++scan) {
    track.scans[scan].T_map_base = {0.5 * static_cast<double>(scan), 0.0, 0.0};
    // To the end of the first piece, and in the middle of the second.
    const bool is_open = (scan >= 60 && scan < 100) || (scan >= 120 && scan < 140);
    track.scans[scan].status = is_open ? TrackStatus::kDegenerate : TrackStatus::kTracked;
  }
  const std::vector<OpenStretch> stretches = open_stretches(track);
  ASSERT_EQ(stretches.size(), 2U);
  EXPECT_NEAR(stretches[0].length_sigma_m, kStepSigma_m * std::sqrt(19.0), 1e-4);
  EXPECT_NEAR(stretches[1].length_sigma_m, kStepSigma_m * std::sqrt(10.0), 1e-4);
}

/// The last scans of a log in a corridor, behind its last keyframe, each `open_sigma_m` unsure.
Map chain_with_open_end(std::size_t num_open, double open_sigma_m, bool has_odometry) {
  Map track = chain_of_pieces({{0, 20, true}}, 0.0);
  MappedScan open;
  open.status = TrackStatus::kDegenerate;
  open.has_odometry = has_odometry;
  for (std::size_t k = 0; k < num_open; ++k) {
    open.T_map_base = {has_odometry ? 0.1 * static_cast<double>(k) : 0.0, 0.0, 0.0};
    open.open_sigma_m = {open_sigma_m, 0.0};
    open.stamp = Timestamp{static_cast<std::int64_t>(k) * 100'000'000};
    track.scans.push_back(open);
  }
  track.pieces.front().num_scans = track.scans.size();
  return track;
}

// A robot stops in a corridor and nobody sees whether it drives on until the log ends.
TEST(TrackCertainty, AnOpenStretchBehindTheLastKeyframeIsReported) {
  const Map track = chain_with_open_end(30, 0.04, false);
  const std::vector<OpenStretch> stretches = open_stretches(track);
  ASSERT_EQ(stretches.size(), 1U);
  EXPECT_EQ(stretches[0].first_scan, 20U);
  EXPECT_EQ(stretches[0].num_scans, 30U);
  EXPECT_NEAR(stretches[0].length_sigma_m, 30 * 0.04, 1e-9);
  EXPECT_NEAR(wrap_to_period(stretches[0].direction_rad, kPi), 0.0, 1e-9);
  const std::vector<double> sigmas_m = position_sigmas_m(track);
  EXPECT_NEAR(sigmas_m[19], kStepSigma_m * 3.0, 1e-6);
  EXPECT_NEAR(sigmas_m.back(), std::hypot(kStepSigma_m * 3.0, 30 * 0.04), 1e-6);
  EXPECT_TRUE(open_stretches(chain_with_open_end(30, 0.001, false)).empty()) << "known to 3 cm";
}

TEST(TrackCertainty, AnOpenStretchBehindTheLastKeyframeByOdometry) {
  const std::vector<OpenStretch> stretches = open_stretches(chain_with_open_end(30, 0.005, true));
  ASSERT_EQ(stretches.size(), 1U);
  EXPECT_NEAR(stretches[0].way_m, 2.9 + 0.0, 1e-6);
  EXPECT_NEAR(stretches[0].length_sigma_m, 30 * 0.005, 1e-9);
}

// The same with a part of the stretch before the last keyframe: the two parts are independent.
TEST(TrackCertainty, AnOpenStretchThatEndsBehindTheLastKeyframe) {
  Map track = chain_with_open_end(30, 0.04, false);
  for (std::size_t scan = 10; scan < 20; ++scan) {
    track.scans[scan].status = TrackStatus::kDegenerate;
  }
  const std::vector<OpenStretch> stretches = open_stretches(track);
  ASSERT_EQ(stretches.size(), 1U);
  EXPECT_EQ(stretches[0].num_scans, 40U);
  // From the keyframe of scan 10 to that of scan 18, then to the end.
  EXPECT_NEAR(stretches[0].length_sigma_m, std::hypot(kStepSigma_m * 2.0, 30 * 0.04), 1e-6);
}

/// From the first room into the corridor, where the robot stands until the log ends.
TEST(TrackCertainty, AStopInACorridorAtTheEndOfALogIsReported) {
  std::vector<Pose2> truth = drive({{1.0, 2.0}, {18.0, 2.0}});
  truth.resize(truth.size() + 100, truth.back());
  std::vector<Scan> scans = scans_on_drive(rooms_and_corridor(), truth, 0.005);
  Mapper mapper;
  for (Scan& scan : scans) {
    for (double& range_m : scan.ranges_m) {
      if (range_m > 8.0) range_m = std::numeric_limits<double>::infinity();
    }
    mapper.add(scan);
  }
  const Map map = mapper.finish();
  ASSERT_FALSE(map.open_stretches.empty());
  const OpenStretch& last = map.open_stretches.back();
  EXPECT_EQ(last.first_scan + last.num_scans, scans.size());
  EXPECT_GT(last.length_sigma_m, 2.0) << "in ten seconds a robot drives some metres";
  EXPECT_GT(map.scans.back().position_sigma_m, 2.0);
}

TEST(TrackCertainty, NoGraphNoCertainty) {
  EXPECT_TRUE(position_sigmas_m({}).empty());
  EXPECT_TRUE(open_stretches({}).empty());
}

// Of a scan that is wrong by itself nothing hangs.
TEST(TrackCertainty, AKeyframeThatWentAstrayIsUncertainAndItsNeighboursAreNot) {
  Map as_tracked = chain_of_pieces({{0, 20, true}}, 0.0);
  Map doubted = as_tracked;
  add_certainty(as_tracked);
  const std::size_t astray[] = {4};  // Scan 8.
  add_certainty(doubted, {}, {}, astray);
  for (std::size_t i = 0; i < doubted.scans.size(); ++i) {
    const MappedScan& scan = doubted.scans[i];
    if (i >= 7 && i <= 9) {
      EXPECT_GT(scan.position_sigma_m, 1.5) << i;
      EXPECT_GT(scan.heading_sigma_rad, rad_from_deg(45.0)) << i;
    } else {
      EXPECT_EQ(scan.position_sigma_m, as_tracked.scans[i].position_sigma_m) << i;
      EXPECT_EQ(scan.heading_sigma_rad, as_tracked.scans[i].heading_sigma_rad) << i;
    }
  }
}

}  // namespace setsquare::track_certainty_test
