// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/map/map.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "setsquare/core/error.hpp"
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

bool has_finite_numbers(const Pose2& pose) {
  return std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.theta_rad);
}

/// Throws ParameterError with the first of the values that is not as it should be.
template <typename Values, typename IsRight>
void require_each(const Values& values, const char* name, const char* fault, IsRight is_right) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (is_right(values[k])) continue;
    throw ParameterError(name + ("[" + std::to_string(k) + "]"), fault);
  }
}

StampedPose pose_from(const MappedScan& scan, PoseOf pose_of) {
  return {scan.stamp, pose_of == PoseOf::kSensor ? scan.T_map_sensor : scan.T_map_base};
}

/// The kept scans that show walls and that `is_wanted`, by their index.
template <typename IsWanted>
std::vector<PlacedScan> placed_where(const Map& map, const IsWanted& is_wanted) {
  std::vector<PlacedScan> placed;
  std::size_t session = 0;
  for (const KeptScan& kept : map.kept_scans) {
    const MappedScan& mapped = map.scans[kept.index];
    while (session + 1 < map.sessions.size() &&
           map.sessions[session + 1].first_scan <= kept.index) {
      ++session;
    }
    if (mapped.status == TrackStatus::kLost || !mapped.is_placed || !is_wanted(kept.index)) {
      continue;
    }
    placed.push_back({kept.scan.get(),
                      mapped.T_map_sensor,
                      map.sessions.empty() ? 0 : map.sessions[session].recency});
  }
  return placed;
}

}  // namespace

bool begins_anew(const Map& map, std::size_t scan) {
  return scan > 0 &&
         (std::ranges::binary_search(map.sessions, scan, {}, &MapSession::first_scan) ||
          std::ranges::binary_search(map.forgotten_poses, scan, {}, &ForgottenPoses::next_scan));
}

bool is_joined(const Map& map, const MapSession& session) {
  return std::ranges::any_of(map.pieces, [&](const TrackPiece& piece) {
    return piece.is_joined && piece.first_scan >= session.first_scan &&
           piece.first_scan < session.first_scan + session.num_scans;
  });
}

void validate(const Map& map) {
  const std::size_t num_scans = map.scans.size();
  const auto is_scan = [&](std::size_t index) { return index < num_scans; };
  const auto are_scans = [&](const auto& stretch) {
    return is_scan(stretch.first_scan) && stretch.num_scans <= num_scans - stretch.first_scan;
  };
  require_each(map.scans, "scans", "has a pose that is not finite", [](const MappedScan& scan) {
    return has_finite_numbers(scan.T_map_sensor) && has_finite_numbers(scan.T_map_base);
  });
  require_each(map.keyframes, "keyframes", "names no scan", is_scan);
  if (!map.headings.empty() && map.headings.size() != map.keyframes.size()) {
    throw ParameterError("headings", "must be one per keyframe");
  }
  require_each(map.headings, "headings", "names no frame", [&](const MappedHeading& heading) {
    return heading.frame < std::max<std::size_t>(map.frames.size(), 1);
  });
  std::size_t num_left = num_scans;
  require_each(map.pieces, "pieces", "has no such scans", [&](const TrackPiece& piece) {
    if (!are_scans(piece) || piece.num_scans > num_left) return false;
    num_left -= piece.num_scans;
    return true;
  });
  std::size_t next_scan = 0;
  require_each(
      map.sessions, "sessions", "does not follow the one before", [&](const auto& session) {
        if (session.first_scan != next_scan || session.num_scans > num_scans - next_scan)
          return false;
        next_scan += session.num_scans;
        return true;
      });
  const MapTrack& track = map.track;
  if (!track.T_odom_sensor.empty() && track.T_odom_sensor.size() != num_scans) {
    throw ParameterError("track.T_odom_sensor", "must be one per scan");
  }
  require_each(track.T_odom_sensor, "track.T_odom_sensor", "is not finite", has_finite_numbers);
  if (!track.motions.empty() && track.motions.size() != map.keyframes.size()) {
    throw ParameterError("track.motions", "must be one per keyframe");
  }
  require_each(
      map.forgotten_poses, "forgotten_poses", "names no scan", [&](const ForgottenPoses& gap) {
        return gap.next_scan <= num_scans && std::isfinite(gap.way_m);
      });
  if (!std::ranges::is_sorted(map.forgotten_poses, {}, &ForgottenPoses::next_scan)) {
    throw ParameterError("forgotten_poses", "are not in the order of the scans");
  }
  require_each(map.open_stretches, "open_stretches", "has no such scans", are_scans);
  require_each(map.closures, "closures", "names no scan", [&](const MappedClosure& closure) {
    return is_scan(closure.scan_i) && is_scan(closure.scan_j);
  });
  require_each(map.undecided_turns, "undecided_turns", "names no scan", [&](const auto& turn) {
    return is_scan(turn.first_scan) && is_scan(turn.last_scan);
  });
  require_each(map.doubts, "doubts", "has no such scans", are_scans);
  require_each(map.kept_scans, "kept_scans", "names no scan", [&](const KeptScan& kept) {
    return is_scan(kept.index) && kept.scan != nullptr;
  });
  for (const KeptScan& kept : map.kept_scans) kept.scan->validate();
  validate(map.graph);
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
  return placed_where(map, [](std::size_t) { return true; });
}

std::vector<PlacedScan> placed_keyframes(const Map& map) {
  return placed_where(
      map, [&](std::size_t scan) { return std::ranges::binary_search(map.keyframes, scan); });
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
