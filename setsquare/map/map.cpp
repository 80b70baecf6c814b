// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/map/map.hpp"

#include <algorithm>

#include "setsquare/grid/grid_from_scans.hpp"

namespace setsquare {

const char* to_string(TrackStatus status) {
  switch (status) {
    case TrackStatus::kTracked:
      return "tracked";
    case TrackStatus::kDegenerate:
      return "degenerate";
    case TrackStatus::kRecovered:
      return "recovered";
    case TrackStatus::kLost:
      return "lost";
  }
  return "unknown";
}

namespace {

StampedPose pose_from(const MappedScan& scan, PoseOf pose_of) {
  return {scan.stamp, pose_of == PoseOf::kSensor ? scan.T_map_sensor : scan.T_map_base};
}

}  // namespace

bool begins_later_session(const Map& map, std::size_t scan) {
  return scan > 0 && std::ranges::any_of(map.sessions, [&](const MapSession& session) {
           return session.first_scan == scan;
         });
}

bool is_joined(const Map& map, const MapSession& session) {
  return std::ranges::any_of(map.pieces, [&](const TrackPiece& piece) {
    return piece.is_joined && piece.first_scan >= session.first_scan &&
           piece.first_scan < session.first_scan + session.num_scans;
  });
}

Trajectory trajectory_of(const Map& map, PoseOf pose_of) {
  Trajectory trajectory;
  trajectory.reserve(map.scans.size());
  for (const MappedScan& scan : map.scans) {
    if (scan.is_placed) trajectory.push_back(pose_from(scan, pose_of));
  }
  return trajectory;
}

Trajectory trajectory_of(const Map& map, const TrackPiece& piece, PoseOf pose_of) {
  Trajectory trajectory;
  trajectory.reserve(piece.num_scans);
  for (std::size_t i = 0; i < piece.num_scans; ++i) {
    trajectory.push_back(pose_from(map.scans[piece.first_scan + i], pose_of));
  }
  return trajectory;
}

std::vector<MappedClosure> closures_of_placed(const Map& map) {
  std::vector<MappedClosure> placed;
  for (const MappedClosure& closure : map.closures) {
    if (!map.scans[closure.scan_i].is_placed || !map.scans[closure.scan_j].is_placed) continue;
    placed.push_back(closure);
  }
  return placed;
}

std::vector<LoopClosure> closures_of(const Map& map) {
  std::vector<LoopClosure> closures;
  closures.reserve(map.closures.size());
  for (const MappedClosure& mapped : map.closures) closures.push_back(mapped.closure);
  return closures;
}

std::vector<PlacedScan> placed_scans(const Map& map) {
  std::vector<PlacedScan> placed;
  std::size_t session = 0;
  placed.reserve(map.kept_scans.size());
  for (const KeptScan& kept : map.kept_scans) {
    const MappedScan& mapped = map.scans[kept.index];
    while (session + 1 < map.sessions.size() &&
           map.sessions[session + 1].first_scan <= kept.index) {
      ++session;
    }
    if (mapped.status == TrackStatus::kLost || !mapped.is_placed) continue;
    placed.push_back({kept.scan.get(),
                      mapped.T_map_sensor,
                      map.sessions.empty() ? 0 : map.sessions[session].recency});
  }
  return placed;
}

OccupancyGrid occupancy_grid(const Map& map, int num_threads, double grid_heading_rad) {
  return occupancy_grid_with_changes(map, num_threads, grid_heading_rad).grid;
}

GridWithChanges occupancy_grid_with_changes(const Map& map,
                                            int num_threads,
                                            double grid_heading_rad) {
  return grid_with_changes(placed_scans(map), grid_heading_rad, {.num_threads = num_threads});
}

}  // namespace setsquare
