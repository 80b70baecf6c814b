// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Writes pages about a made-up room of 8 x 9 m for tests/browser/map_report_test.py, which knows
// the room's walls and the closures below by heart: write_map_report FOLDER
#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "setsquare/core/save_file.hpp"
#include "setsquare/grid/grid_from_scans.hpp"
#include "setsquare/report/map/page.hpp"
#include "setsquare/scan/scan_to_points.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare {
namespace {

constexpr int kNumPoses = 240;
constexpr int kPosesPerRound = 120;
constexpr int kPosesPerScan = 5;

Timestamp stamp_of(int pose) { return timestamp_from_seconds(1000.0 + 0.5 * pose); }

/// Twice round the room on nearly the same ellipse.
Pose2 pose_of(int pose) {
  const double turn = kTwoPi * pose / kPosesPerRound;
  const double wider = pose < kPosesPerRound ? 0.0 : 0.25;
  return {4.0 + (1.9 + wider) * std::cos(turn),
          2.9 + (0.9 + wider) * std::sin(turn),
          wrap_to_pi(turn + 0.5 * kPi)};
}

Scan scan_at(const Pose2& T_map_base) {
  const testing::Fan all_around = {360, -kPi, kTwoPi / 360};
  return testing::scan_of_walls(testing::l_shaped_room(), T_map_base, all_around);
}

ReportPose report_pose(int pose) {
  ReportPose row = {stamp_of(pose), pose_of(pose)};
  row.sigma_m = pose >= 90 && pose < 130 ? 0.3 : 0.01;
  if (pose >= 40 && pose < 50) row.condition = ReportCondition::kDegenerate;
  if (pose >= 160 && pose < 165) row.condition = ReportCondition::kLost;
  if (pose == 165) row.condition = ReportCondition::kRecovered;
  return row;
}

ReportHeading report_heading(int pose) {
  const double heading_rad = pose_of(pose).theta_rad;
  ReportHeading row;
  row.stamp = stamp_of(pose);
  row.measured_rad = wrap_to_pi(heading_rad + 0.01 * std::sin(pose) + 0.5 * kPi * (pose % 4));
  row.frame = pose < kPosesPerRound ? 0 : 1;
  row.weight = 1.0;
  row.fused_rad = heading_rad;
  row.tracked_rad = heading_rad + 0.002 * pose;
  return row;
}

/// A closure of the scans taken at the same place of the first and the second round.
ReportClosure closure_of(const std::vector<ReportScan>& scans, std::size_t place) {
  ReportClosure row;
  row.scan_i = place;
  row.scan_j = place + kPosesPerRound / kPosesPerScan;
  row.closure.stamp_i = scans[row.scan_i].stamp;
  row.closure.stamp_j = scans[row.scan_j].stamp;
  row.closure.T_i_j = scans[row.scan_i].T_map_base.inverse() * scans[row.scan_j].T_map_base;
  row.closure.is_accepted = true;
  row.closure.weight = 1.0;
  row.closure.reason = "verified <by> \"hand\" & eye";
  return row;
}

/// 0 right, 1 along x only, 2 right, 3 outvoted, 4 and 5 refused and 0.8 m off.
std::vector<ReportClosure> closures_of(const std::vector<ReportScan>& scans) {
  std::vector<ReportClosure> closures;
  for (const std::size_t place : {2U, 6U, 10U, 14U, 18U, 22U}) {
    closures.push_back(closure_of(scans, place));
  }
  closures[1].closure.axes = ClosureAxes::kX;
  closures[3].closure.weight = 0.1;
  for (const std::size_t wrong : {4U, 5U}) {
    LoopClosure& closure = closures[wrong].closure;
    closure.T_i_j = closure.T_i_j * Pose2{0.6, 0.53, 0.2};
    closure.is_accepted = false;
    closure.weight = 0.0;
    closure.reason = "contradicted";
  }
  return closures;
}

MapReport report_of_room(const OccupancyGrid& grid, const std::vector<Scan>& scans) {
  MapReport report;
  report.title = "Room </script><b id=\"injected\">\"1\"</b> & <!-- more";
  report.grid = &grid;
  for (int pose = 0; pose < kNumPoses; ++pose) {
    report.poses.push_back(report_pose(pose));
    if (pose % 2 == 0) report.headings.push_back(report_heading(pose));
  }
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const int pose = kPosesPerScan * static_cast<int>(i);
    report.scans.push_back({stamp_of(pose), pose_of(pose), points_from_scan(scans[i])});
  }
  report.closures = closures_of(report.scans);
  report.frame_headings_rad = {0.0, rad_from_deg(30.0)};
  report.figures = {{"Track", "scans", "240", "", "Sweeps <of> the laser."},
                    {"Map", "cell", "5", "cm", ""}};
  return report;
}

void write_pages(const std::string& folder) {
  std::vector<Scan> scans;
  std::vector<PlacedScan> placed;
  for (int pose = 0; pose < kNumPoses; pose += kPosesPerScan)
    scans.push_back(scan_at(pose_of(pose)));
  for (std::size_t i = 0; i < scans.size(); ++i) {
    placed.push_back({&scans[i], pose_of(kPosesPerScan * static_cast<int>(i))});
  }
  const OccupancyGrid grid = grid_from_scans(placed);
  const MapReport room = report_of_room(grid, scans);
  save_file(folder + "/room.html", map_report_html(room));

  // The same room in a grid whose rows run at 20 degrees in the map: it stands askew.
  const OccupancyGrid askew_grid = grid_from_scans(placed, rad_from_deg(20.0));
  MapReport askew = room;
  askew.grid = &askew_grid;
  save_file(folder + "/askew.html", map_report_html(askew));

  MapReport bare;
  bare.title = "Nothing";
  save_file(folder + "/bare.html", map_report_html(bare));

  const OccupancyGrid unknown({}, 0.05, 40, 40);
  MapReport single;
  single.title = "One pose";
  single.grid = &unknown;
  single.poses = {{stamp_of(0), pose_of(0)}};  // Its confidence is not known.
  save_file(folder + "/single.html", map_report_html(single));
}

}  // namespace
}  // namespace setsquare

int main(int num_arguments, char** arguments) {
  if (num_arguments != 2) {
    std::cerr << "usage: write_map_report FOLDER\n";
    return 2;
  }
  try {
    setsquare::write_pages(arguments[1]);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
