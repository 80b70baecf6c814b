// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/map/map_summary.hpp"

#include <algorithm>

namespace setsquare {
namespace {

double step_m(const Map& map, std::size_t i) {
  return (map.scans[i].T_map_base.translation() - map.scans[i - 1].T_map_base.translation()).norm();
}

void count_scans(const Map& map, MapSummary& summary) {
  summary.num_scans = map.scans.size();
  summary.num_keyframes = map.keyframes.size();
  summary.num_forgotten = map.num_forgotten;
  for (const ForgottenPoses& gap : map.forgotten_poses) {
    summary.num_forgotten_poses += gap.num_scans;
    summary.path_m += gap.way_m;
  }
  for (std::size_t i = 0; i < map.scans.size(); ++i) {
    const TrackStatus status = map.scans[i].status;
    summary.num_tracked += status == TrackStatus::kTracked;
    summary.num_degenerate += status == TrackStatus::kDegenerate;
    summary.num_recovered += status == TrackStatus::kRecovered;
    summary.num_lost += status == TrackStatus::kLost;
    const bool is_step =
        i > 0 && map.scans[i].is_placed && map.scans[i - 1].is_placed && !begins_anew(map, i);
    if (is_step) summary.path_m += step_m(map, i);
  }
}

void count_closures(const Map& map, MapSummary& summary) {
  const std::vector<MappedClosure> closures = closures_of_placed(map);
  summary.num_compared_closures = closures.size();
  for (const MappedClosure& mapped : closures) {
    const LoopClosure& closure = mapped.closure;
    if (!closure.is_accepted) continue;
    ++summary.num_accepted_closures;
    summary.num_one_axis_closures += closure.axes != ClosureAxes::kXY;
    summary.num_outvoted_closures += closure.is_outvoted();
  }
}

}  // namespace

MapSummary summary_of(const Map& map) {
  MapSummary summary;
  count_scans(map, summary);
  count_closures(map, summary);
  for (const TrackPiece& piece : map.pieces) {
    summary.num_unjoined_pieces += !piece.is_joined;
    summary.num_unjoined_scans += piece.is_joined ? 0 : piece.num_scans;
  }
  for (const OpenStretch& stretch : map.open_stretches) {
    summary.open_m += stretch.way_m;
    summary.open_s += stretch.duration_s;
    summary.worst_length_sigma_m = std::max(summary.worst_length_sigma_m, stretch.length_sigma_m);
    const bool is_heading_open = stretch.is_turn && stretch.heading_sigma_rad > kOpenHeading_rad;
    if (is_heading_open) summary.open_headings.push_back(stretch);
  }
  return summary;
}

std::vector<StatusStretch> status_stretches(const Map& map) {
  std::vector<StatusStretch> found;
  for (std::size_t i = 0; i < map.scans.size(); ++i) {
    const TrackStatus status = map.scans[i].status;
    if (status == TrackStatus::kTracked) continue;
    const bool begins = i == 0 || begins_anew(map, i);
    const bool continues = !begins && map.scans[i - 1].status == status;
    if (!continues) {
      found.push_back({.status = status, .first_scan = i, .num_scans = 0, .path_m = 0.0});
    }
    ++found.back().num_scans;
    if (!begins) found.back().path_m += step_m(map, i);
  }
  return found;
}

}  // namespace setsquare
