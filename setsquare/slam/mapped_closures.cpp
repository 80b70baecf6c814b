// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/slam/mapped_closures.hpp"

#include <cmath>
#include <string>

namespace setsquare {
namespace {

/// Derivative of T_sensor_sensor by T_base_base, both as (x, y, theta) in the frame of their first.
Eigen::Matrix3d derivative_by_base(const Pose2& T_base_sensor_from,
                                   const Pose2& T_base_base,
                                   const Pose2& T_base_sensor_to) {
  // T_ss = M1^-1 T_bb M2: p_ss = R(-m1) (p_bb + R(theta_bb) p_m2 - p_m1).
  const double c = std::cos(T_base_sensor_from.theta_rad);
  const double s = std::sin(T_base_sensor_from.theta_rad);
  const Pose2 turn{0.0, 0.0, T_base_base.theta_rad};
  const Eigen::Vector2d lever = turn * T_base_sensor_to.translation();
  Eigen::Matrix2d R;
  R << c, s, -s, c;
  Eigen::Matrix3d J = Eigen::Matrix3d::Identity();
  J.topLeftCorner<2, 2>() = R;
  J.topRightCorner<2, 1>() = R * Eigen::Vector2d(-lever.y(), lever.x());
  return J;
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
        .axes = places.verdict.axes,
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
    constraint.T_from_to = from * constraint.T_from_to * to.inverse();
    const Eigen::Matrix3d J = derivative_by_base(from, constraint.T_from_to, to);
    constraint.information = J.transpose() * constraint.information * J;
  }
  for (HeadingMeasurement& heading : of_base.headings) {
    heading.heading_rad = wrap_to_pi(heading.heading_rad -
                                     track.keyframes[heading.node]->scan.T_base_sensor.theta_rad);
  }
  return of_base;
}

}  // namespace setsquare
