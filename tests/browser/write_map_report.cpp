// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Writes pages about a made-up room of 8 x 9 m for tests/browser/map_report_test.py, which knows
// the room's walls and the closures below by heart: write_map_report FOLDER
#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "setsquare/core/save_file.hpp"
#include "setsquare/grid/grid_from_scans.hpp"
#include "setsquare/report/map/page.hpp"
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

MappedScan mapped_scan(int pose) {
  MappedScan scan;
  scan.stamp = stamp_of(pose);
  scan.T_map_base = scan.T_map_sensor = pose_of(pose);
  scan.position_sigma_m = pose >= 90 && pose < 130 ? 0.3 : 0.01;
  if (pose >= 40 && pose < 50) scan.status = TrackStatus::kDegenerate;
  if (pose >= 160 && pose < 165) scan.status = TrackStatus::kLost;
  if (pose == 165) scan.status = TrackStatus::kRecovered;
  return scan;
}

MappedHeading heading_of(int pose) {
  const double heading_rad = pose_of(pose).theta_rad;
  return {.tracked_rad = heading_rad + 0.002 * pose,
          .measured_rad = wrap_to_pi(heading_rad + 0.01 * std::sin(pose) + 0.5 * kPi * (pose % 4)),
          .weight = 1.0,
          .frame = pose < kPosesPerRound ? 0U : 1U};
}

/// A closure of the kept scans taken at the same place of the first and the second round.
MappedClosure closure_of(const Map& map, std::size_t place) {
  MappedClosure row;
  row.scan_i = map.kept_scans[place].index;
  row.scan_j = map.kept_scans[place + kPosesPerRound / kPosesPerScan].index;
  const MappedScan& scan_i = map.scans[row.scan_i];
  const MappedScan& scan_j = map.scans[row.scan_j];
  row.closure.stamp_i = scan_i.stamp;
  row.closure.stamp_j = scan_j.stamp;
  row.closure.T_i_j = scan_i.T_map_base.inverse() * scan_j.T_map_base;
  row.closure.is_accepted = true;
  row.closure.weight = 1.0;
  row.closure.reason = "verified <by> \"hand\" & eye";
  return row;
}

/// 0 right, 1 along x only, 2 right, 3 outvoted, 4 and 5 refused and 0.8 m off.
void add_closures(Map& map) {
  for (const std::size_t place : {2U, 6U, 10U, 14U, 18U, 22U}) {
    map.closures.push_back(closure_of(map, place));
  }
  map.closures[1].closure.axes = ClosureAxes::kX;
  map.closures[3].closure.weight = 0.1;
  for (const std::size_t wrong : {4U, 5U}) {
    LoopClosure& closure = map.closures[wrong].closure;
    closure.T_i_j = closure.T_i_j * Pose2{0.6, 0.53, 0.2};
    closure.is_accepted = false;
    closure.weight = 0.0;
    closure.reason = "contradicted";
  }
}

Map map_of_room() {
  Map map;
  for (int pose = 0; pose < kNumPoses; ++pose) {
    const auto index = static_cast<std::size_t>(pose);
    map.scans.push_back(mapped_scan(pose));
    if (pose % kPosesPerScan == 0) {
      map.kept_scans.push_back({index, std::make_shared<Scan>(scan_at(pose_of(pose)))});
    }
    if (pose % 2 != 0) continue;
    map.keyframes.push_back(index);
    map.headings.push_back(heading_of(pose));
  }
  add_closures(map);
  map.frames = {{.offset_rad = 0.0}, {.offset_rad = rad_from_deg(30.0)}};
  return map;
}

void write_pages(const std::string& folder) {
  const Map map = map_of_room();
  std::vector<PlacedScan> placed;
  for (const KeptScan& kept : map.kept_scans) {
    placed.push_back({kept.scan.get(), map.scans[kept.index].T_map_sensor});
  }
  const OccupancyGrid grid = grid_from_scans(placed);
  const std::vector<ReportFigure> figures = {
      {"Track", "scans", "240", "", "Sweeps <of> the laser."}, {"Map", "cell", "5", "cm", ""}};
  const std::string title = "Room </script><b id=\"injected\">\"1\"</b> & <!-- more";
  const auto save = [&](const std::string& name, const MapReport& report) {
    save_file(folder + "/" + name, map_report_html(report));
  };
  save("room.html", {.title = title, .map = map, .grid = &grid, .figures = figures});

  // The same room in a grid whose rows run at 20 degrees in the map: it stands at an angle.
  const OccupancyGrid askew = grid_from_scans(placed, rad_from_deg(20.0));
  save("askew.html", {.title = title, .map = map, .grid = &askew, .figures = figures});

  const Map nothing;
  save("bare.html", {.title = "Nothing", .map = nothing});

  const OccupancyGrid unknown({}, 0.05, 40, 40);
  Map single;  // Its confidence is not known.
  single.scans.resize(1);
  single.scans[0].stamp = stamp_of(0);
  single.scans[0].T_map_base = single.scans[0].T_map_sensor = pose_of(0);
  save("single.html", {.title = "One pose", .map = single, .grid = &unknown});
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
