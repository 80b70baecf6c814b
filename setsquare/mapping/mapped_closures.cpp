// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/mapped_closures.hpp"

#include <cmath>
#include <string>

#include "setsquare/matching/base_frame.hpp"

namespace setsquare {
namespace {

/// Which axes of the final map a closure binds: the map may have turned since it was judged.
ClosureAxes axes_of(const ComparedPlaces& places, const PoseGraph& graph) {
  if (places.verdict.reason != ClosureReason::kOneAxis) return places.verdict.axes;
  const Eigen::Matrix2d bound = places.information.topLeftCorner<2, 2>();
  const Eigen::Vector2d open = open_direction(bound).direction;
  return axis_across(std::atan2(open.y(), open.x()) + graph.T_map_node[places.from].theta_rad);
}

}  // namespace

std::vector<MappedClosure> mapped_closures(const KeyframeTrack& track,
                                           std::span<const ComparedPlaces> compared,
                                           const PoseGraph& graph) {
  std::vector<MappedClosure> closures;
  std::size_t next = track.size() > 0 ? track.size() - 1 : 0;
  for (const ComparedPlaces& places : compared) {
    const Scan& scan_i = track.keyframes[places.from]->scan;
    const Scan& scan_j = track.keyframes[places.to]->scan;
    MappedClosure mapped;
    mapped.scan_i = track.keyframes[places.from]->scan_index;
    mapped.scan_j = track.keyframes[places.to]->scan_index;
    const bool accepted = is_accepted(places.verdict.reason);
    mapped.closure = {
        .stamp_i = scan_i.stamp,
        .stamp_j = scan_j.stamp,
        .T_i_j = scan_i.T_base_sensor * places.T_from_to * scan_j.T_base_sensor.inverse(),
        .axes = axes_of(places, graph),
        .is_accepted = accepted,
        .weight = accepted ? graph.constraints[next].weight : 0.0,
        .reason = std::string(to_string(places.verdict.reason))};
    if (accepted) ++next;
    closures.push_back(std::move(mapped));
  }
  return closures;
}

std::vector<TrackPiece> pieces_of(const KeyframeTrack& track,
                                  const std::vector<bool>& is_joined,
                                  std::size_t num_scans) {
  std::vector<TrackPiece> pieces;
  for (std::size_t k = 0; k < track.size(); ++k) {
    if (track.pieces[k] < pieces.size()) continue;
    const std::size_t first = pieces.empty() ? 0 : track.keyframes[k]->scan_index;
    if (!pieces.empty()) pieces.back().num_scans = first - pieces.back().first_scan;
    pieces.push_back({first, num_scans - first, is_joined[track.pieces[k]]});
  }
  return pieces;
}

PoseGraph graph_of_base(const KeyframeTrack& track, const PoseGraph& graph) {
  PoseGraph of_base = graph;
  for (std::size_t k = 0; k < track.size(); ++k) {
    of_base.T_map_node[k] = graph.T_map_node[k] * track.keyframes[k]->scan.T_base_sensor.inverse();
  }
  for (Constraint& constraint : of_base.constraints) {
    const Pose2& from = track.keyframes[constraint.from]->scan.T_base_sensor;
    const Pose2& to = track.keyframes[constraint.to]->scan.T_base_sensor;
    constraint.information =
        information_of_base(constraint.information, constraint.T_from_to, from, to);
    constraint.T_from_to = from * constraint.T_from_to * to.inverse();
  }
  for (HeadingMeasurement& heading : of_base.headings) {
    heading.heading_rad = wrap_to_pi(heading.heading_rad -
                                     track.keyframes[heading.node]->scan.T_base_sensor.theta_rad);
  }
  return of_base;
}

}  // namespace setsquare
