// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/map/image.hpp"

#include <algorithm>
#include <vector>

#include "apps/setsquare/map/report.hpp"
#include "setsquare/grid/grid_from_scans.hpp"
#include "setsquare/report/map/building_heading.hpp"
#include "setsquare/report/map/picture.hpp"

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
  const std::vector<bool> is_placed = scans_placed(run.track);
  for (const PictureScan& kept : run.picture_scans) {
    const MappedScan& mapped = run.track.scans[kept.index];
    if (mapped.status == TrackStatus::kLost || !is_placed[kept.index]) continue;
    placed.push_back({&kept.scan, mapped.T_map_sensor});
  }
  return placed;
}

}  // namespace

std::vector<bool> scans_placed(const MappedTrack& track) {
  std::vector<bool> is_placed(track.scans.size(), true);
  for (const TrackPiece& piece : track.pieces) {
    if (piece.is_joined) continue;
    const auto first = is_placed.begin() + static_cast<std::ptrdiff_t>(piece.first_scan);
    std::fill(first, first + static_cast<std::ptrdiff_t>(piece.num_scans), false);
  }
  return is_placed;
}

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
  const std::vector<bool> is_placed = scans_placed(run.track);
  for (std::size_t i = 0; i < is_placed.size(); ++i) {
    conditions.push_back(is_placed[i] ? condition_from(run.track.scans[i].status)
                                      : TrackCondition::kNotPlaced);
  }
  const std::vector<LoopClosure> closures = closures_of(run.track);
  const Trajectory trajectory = trajectory_from(run.track, false);
  return layered_map_picture(
      grid, {.T_map_base = trajectory, .conditions = conditions, .closures = closures});
}

}  // namespace setsquare::app
