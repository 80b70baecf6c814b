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

std::vector<PlacedScan> placed_scans(const MapRun& run) {
  std::vector<PlacedScan> placed;
  placed.reserve(run.picture_scans.size());
  for (const PictureScan& kept : run.picture_scans) {
    const MappedScan& mapped = run.track.scans[kept.index];
    if (mapped.status == TrackStatus::kLost) continue;
    placed.push_back({&kept.scan, mapped.T_map_sensor});
  }
  return placed;
}

}  // namespace

OccupancyGrid map_grid(const MapRun& run, int num_threads) {
  return grid_from_scans(placed_scans(run), 0.0, {.num_threads = num_threads});
}

OccupancyGrid upright_map_grid(const MapRun& run, int num_threads) {
  const std::vector<PlacedScan> placed = placed_scans(run);
  return grid_from_scans(placed, building_heading_rad(placed), {.num_threads = num_threads});
}

std::vector<LoopClosure> closures_of(const MappedTrack& track) {
  std::vector<LoopClosure> closures;
  closures.reserve(track.closures.size());
  for (const MappedClosure& mapped : track.closures) closures.push_back(mapped.closure);
  return closures;
}

Image map_image(const MapRun& run, const OccupancyGrid& grid) {
  std::vector<TrackCondition> conditions;
  conditions.reserve(run.track.scans.size());
  for (const MappedScan& mapped : run.track.scans) {
    conditions.push_back(condition_from(mapped.status));
  }
  const std::vector<LoopClosure> closures = closures_of(run.track);
  const Trajectory trajectory = trajectory_from(run.track, false);
  return layered_map_picture(
      grid, {.T_map_base = trajectory, .conditions = conditions, .closures = closures});
}

void save_map_image(const MapRun& run, const std::string& path) {
  save_png(map_image(run, upright_map_grid(run)), path);
}

}  // namespace setsquare::app
