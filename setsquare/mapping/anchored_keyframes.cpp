// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/anchored_keyframes.hpp"

#include <cmath>

#include "setsquare/core/angle.hpp"

namespace setsquare {

Pose2 motion_to_anchors(const PoseGraph& graph, std::span<const AnchoredKeyframe> anchors) {
  constexpr double kHeadingWeight_m2 = 1.0;  // Of a keyframe's heading: a robot may have stood.
  const auto num = static_cast<double>(anchors.size());
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  for (const AnchoredKeyframe& anchor : anchors) {
    from += graph.T_map_node[anchor.keyframe].translation() / num;
    to += anchor.T_map_sensor.translation() / num;
  }
  double sin_sum = 0.0;
  double cos_sum = 0.0;
  for (const AnchoredKeyframe& anchor : anchors) {
    const Pose2& node = graph.T_map_node[anchor.keyframe];
    const Eigen::Vector2d a = node.translation() - from;
    const Eigen::Vector2d b = anchor.T_map_sensor.translation() - to;
    const double turn_rad = anchor.T_map_sensor.theta_rad - node.theta_rad;
    sin_sum += a.x() * b.y() - a.y() * b.x() + kHeadingWeight_m2 * std::sin(turn_rad);
    cos_sum += a.dot(b) + kHeadingWeight_m2 * std::cos(turn_rad);
  }
  const double turn_rad = std::atan2(sin_sum, cos_sum);
  const Eigen::Vector2d shift_m = to - rotation_matrix(turn_rad) * from;
  return {shift_m.x(), shift_m.y(), turn_rad};
}

void move_by(const Pose2& T, PoseGraph& graph, FusedHeadings& headings) {
  for (Pose2& node : graph.T_map_node) node = T * node;
  for (HeadingMeasurement& heading : graph.headings) {
    heading.heading_rad = wrap_to_pi(heading.heading_rad + T.theta_rad);
  }
  for (std::size_t k = 0; k < headings.heading_rad.size(); ++k) {
    headings.heading_rad[k] += T.theta_rad;
    headings.drift_rad[k] += T.theta_rad;
    headings.measured_heading_rad[k] += T.theta_rad;
  }
}

}  // namespace setsquare
