// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/slam/keyframe_track.hpp"

#include <cassert>
#include <Eigen/LU>

namespace setsquare {
namespace {

/// The motion from keyframe k - 1 to k, its covariance turned from the odom frame into that of
/// keyframe k - 1.
Constraint motion_constraint(const KeyframeTrack& track, std::size_t k, const Pose2& T_from_to) {
  const MotionCovariance& covariance = track.motions[k];
  const Eigen::Matrix2d R = rotation_matrix(-track.keyframes[k - 1]->T_odom_sensor.theta_rad);
  Constraint constraint;
  constraint.from = k - 1;
  constraint.to = k;
  constraint.T_from_to = T_from_to;
  constraint.information.setZero();
  constraint.information.topLeftCorner<2, 2>() =
      (R * covariance.translation_m2 * R.transpose()).inverse();
  constraint.information(2, 2) = 1.0 / covariance.rotation_rad2;
  return constraint;
}

}  // namespace

PoseGraph pose_graph_of(const KeyframeTrack& track, std::span<const double> headings_rad) {
  assert(headings_rad.size() == track.size());
  PoseGraph graph;
  graph.T_map_node.reserve(track.size());
  graph.constraints.reserve(track.size());
  for (std::size_t k = 0; k < track.size(); ++k) {
    const double heading_rad = wrap_to_pi(headings_rad[k]);
    if (k == 0) {
      graph.T_map_node.push_back({0.0, 0.0, heading_rad});
      continue;
    }
    const Pose2& T_odom_before = track.keyframes[k - 1]->T_odom_sensor;
    const Pose2& T_odom_sensor = track.keyframes[k]->T_odom_sensor;
    const Pose2& T_map_before = graph.T_map_node.back();
    const double drift_before_rad = headings_rad[k - 1] - T_odom_before.theta_rad;
    const double drift_rad = headings_rad[k] - T_odom_sensor.theta_rad;
    const double turn_rad = drift_before_rad + 0.5 * wrap_to_pi(drift_rad - drift_before_rad);
    const Eigen::Vector2d moved_m =
        rotation_matrix(turn_rad) * (T_odom_sensor.translation() - T_odom_before.translation());
    const Eigen::Vector2d seen_m = rotation_matrix(-T_map_before.theta_rad) * moved_m;
    graph.constraints.push_back(motion_constraint(
        track,
        k,
        {seen_m.x(), seen_m.y(), wrap_to_pi(T_odom_sensor.theta_rad - T_odom_before.theta_rad)}));
    graph.T_map_node.push_back(
        {T_map_before.x_m + moved_m.x(), T_map_before.y_m + moved_m.y(), heading_rad});
  }
  return graph;
}

}  // namespace setsquare
