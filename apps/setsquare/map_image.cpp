// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/map_image.hpp"

#include <vector>

#include "apps/setsquare/map_report.hpp"
#include "setsquare/drawing/png.hpp"
#include "setsquare/grid/grid_from_scans.hpp"
#include "setsquare/report/building_heading.hpp"
#include "setsquare/report/map_picture.hpp"

namespace setsquare::app {
namespace {

TrackCondition condition_from(TrackStatus status) {
  switch (status) {
    case TrackStatus::kDegenerate:
      return TrackCondition::kDegenerate;
    case TrackStatus::kLost:
      return TrackCondition::kLost;
    case TrackStatus::kTracked:
    case TrackStatus::kRecovered:
      break;
  }
  return TrackCondition::kTracked;
}

}  // namespace

void save_map_image(const MapRun& run, const std::string& path) {
  std::vector<PlacedScan> placed;
  placed.reserve(run.picture_scans.size());
  for (const PictureScan& kept : run.picture_scans) {
    const MappedScan& mapped = run.track.scans[kept.index];
    // A lost scan would smear walls where nobody knows it to be.
    if (mapped.status == TrackStatus::kLost) continue;
    placed.push_back({&kept.scan, mapped.T_map_sensor});
  }
  std::vector<TrackCondition> conditions;
  conditions.reserve(run.track.scans.size());
  for (const MappedScan& mapped : run.track.scans) {
    conditions.push_back(condition_from(mapped.status));
  }
  const OccupancyGrid grid = grid_from_scans(placed, building_heading_rad(placed));
  save_png(map_picture(grid, trajectory_from(run.track, false), conditions), path);
}

}  // namespace setsquare::app
