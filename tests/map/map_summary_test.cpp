// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/map/map_summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace setsquare::map_summary_test {

/// Ten scans along x, 0.5 m apart; each status is seen; the last three are not joined.
Map ten_scans() {
  Map map;
  const TrackStatus statuses[] = {TrackStatus::kTracked,
                                  TrackStatus::kDegenerate,
                                  TrackStatus::kDegenerate,
                                  TrackStatus::kRecovered,
                                  TrackStatus::kTracked,
                                  TrackStatus::kDegenerate,
                                  TrackStatus::kLost,
                                  TrackStatus::kTracked,
                                  TrackStatus::kTracked,
                                  TrackStatus::kTracked};
  for (int i = 0; i < 10; ++i) {
    MappedScan scan;
    scan.stamp = Timestamp{i};
    scan.status = statuses[i];
    scan.is_placed = i < 7;
    scan.T_map_base = {0.5 * i, 0.0, 0.0};
    scan.T_map_sensor = {0.5 * i + 0.2, 0.0, 0.0};
    map.scans.push_back(scan);
  }
  map.keyframes = {0, 3, 7};
  map.pieces = {{0, 7, true}, {7, 3, false}};
  return map;
}

LoopClosure closure(bool is_accepted, ClosureAxes axes, double weight) {
  LoopClosure closure;
  closure.is_accepted = is_accepted;
  closure.axes = axes;
  closure.weight = weight;
  return closure;
}

TEST(MapSummary, CountsScansByStatusAndPieces) {
  const MapSummary summary = summary_of(ten_scans());
  EXPECT_EQ(summary.num_scans, 10U);
  EXPECT_EQ(summary.num_keyframes, 3U);
  EXPECT_EQ(summary.num_tracked, 5U);
  EXPECT_EQ(summary.num_degenerate, 3U);
  EXPECT_EQ(summary.num_recovered, 1U);
  EXPECT_EQ(summary.num_lost, 1U);
  EXPECT_EQ(summary.num_unjoined_pieces, 1U);
  EXPECT_EQ(summary.num_unjoined_scans, 3U);
  EXPECT_NEAR(summary.path_m, 3.0, 1e-12) << "the three of the piece not joined are left out";
}

TEST(MapSummary, CountsClosuresByTheirFinalWeight) {
  Map map;
  map.scans.resize(2);
  map.scans[1].is_placed = false;
  map.closures = {
      {closure(true, ClosureAxes::kXY, 1.0), 0, 0},
      {closure(true, ClosureAxes::kX, 1.0), 0, 1},  // Not placed: neither shown nor counted.
      {closure(true, ClosureAxes::kX, 0.9), 0, 0},
      {closure(true, ClosureAxes::kXY, 0.49), 0, 0},
      {closure(false, ClosureAxes::kXY, 0.0), 0, 0}};
  const MapSummary summary = summary_of(map);
  EXPECT_EQ(summary.num_compared_closures, 4U);
  EXPECT_EQ(summary.num_accepted_closures, 3U);
  EXPECT_EQ(summary.num_one_axis_closures, 1U);
  EXPECT_EQ(summary.num_outvoted_closures, 1U);
}

TEST(MapSummary, OpenStretchesAddUpAndTheWorstOneCounts) {
  Map map;
  map.open_stretches = {{.way_m = 3.0, .length_sigma_m = 0.1},
                        {.way_m = 4.0, .length_sigma_m = 0.4},
                        {.way_m = 5.0, .length_sigma_m = 0.2}};
  const MapSummary summary = summary_of(map);
  EXPECT_NEAR(summary.open_m, 12.0, 1e-12);
  EXPECT_EQ(summary.worst_length_sigma_m, 0.4);
}

TEST(StatusStretches, AreRunsOfOneStatusOtherThanTracked) {
  const std::vector<StatusStretch> stretches = status_stretches(ten_scans());
  ASSERT_EQ(stretches.size(), 4U);
  EXPECT_EQ(stretches[0].status, TrackStatus::kDegenerate);
  EXPECT_EQ(stretches[0].first_scan, 1U);
  EXPECT_EQ(stretches[0].num_scans, 2U);
  EXPECT_NEAR(stretches[0].path_m, 1.0, 1e-12);
  EXPECT_EQ(stretches[1].status, TrackStatus::kRecovered);
  EXPECT_EQ(stretches[2].status, TrackStatus::kDegenerate);
  EXPECT_EQ(stretches[3].status, TrackStatus::kLost);
  EXPECT_EQ(stretches[3].first_scan, 6U);
}

TEST(Map, TrajectoryIsOfTheRobotOrOfTheSensor) {
  const Map map = ten_scans();
  ASSERT_EQ(trajectory_of(map).size(), 7U) << "three are not placed";
  EXPECT_EQ(trajectory_of(map, map.pieces[1]).front().stamp, Timestamp{7});
  EXPECT_EQ(trajectory_of(map)[4].pose.x_m, 2.0);
  EXPECT_EQ(trajectory_of(map, PoseOf::kSensor)[4].pose.x_m, 2.2);
  EXPECT_EQ(trajectory_of(map)[4].stamp, Timestamp{4});
}

TEST(Map, WallsAreDrawnOfPlacedScansAlone) {
  Map map = ten_scans();
  const auto scan = std::make_shared<Scan>();
  for (std::size_t i = 0; i < 10; ++i) map.kept_scans.push_back({i, scan});
  std::vector<double> x_m;
  for (const PlacedScan& placed : placed_scans(map)) x_m.push_back(placed.T_map_sensor.x_m);
  // All but the lost one and those of the piece that is not joined.
  ASSERT_EQ(x_m.size(), 6U);
  EXPECT_NEAR(x_m.back(), 0.5 * 5 + 0.2, 1e-12);
}

TEST(Map, PlacedKeyframesAreThoseOfPlacedScans) {
  Map map = ten_scans();
  map.keyframes = {0, 3, 6, 8};
  const auto scan = std::make_shared<Scan>();
  for (std::size_t i = 0; i < 10; ++i) map.kept_scans.push_back({i, scan});
  std::vector<double> x_m;
  for (const PlacedScan& placed : placed_keyframes(map)) x_m.push_back(placed.T_map_sensor.x_m);
  // One is lost, one not placed.
  ASSERT_EQ(x_m.size(), 2U);
  EXPECT_EQ(x_m[0], map.scans[0].T_map_sensor.x_m);
  EXPECT_EQ(x_m[1], map.scans[3].T_map_sensor.x_m);
}

TEST(Map, EveryStatusHasAName) {
  EXPECT_STREQ(to_string(TrackStatus::kTracked), "tracked");
  EXPECT_STREQ(to_string(TrackStatus::kDegenerate), "degenerate");
  EXPECT_STREQ(to_string(TrackStatus::kRecovered), "recovered");
  EXPECT_STREQ(to_string(TrackStatus::kLost), "lost");
}

}  // namespace setsquare::map_summary_test
