// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/base_frame.hpp"

#include <cmath>
#include <Eigen/LU>

namespace setsquare {

Eigen::Matrix3d information_of_base(const Eigen::Matrix3d& of_sensor,
                                    const Pose2& T_sensor_sensor,
                                    const Pose2& T_base_sensor_reference,
                                    const Pose2& T_base_sensor_current) {
  // d(pose of base) = J d(pose of sensor), so the information becomes J^-T information J^-1.
  const double turn_rad = T_base_sensor_reference.theta_rad;
  const Pose2 T_sensor_base_current = T_base_sensor_current.inverse();
  const Pose2 lever = Pose2{0.0, 0.0, turn_rad + T_sensor_sensor.theta_rad} *
                      Pose2{T_sensor_base_current.x_m, T_sensor_base_current.y_m, 0.0};
  Eigen::Matrix3d J;
  J << std::cos(turn_rad), -std::sin(turn_rad), -lever.y_m,  //
      std::sin(turn_rad), std::cos(turn_rad), lever.x_m,     //
      0.0, 0.0, 1.0;
  const Eigen::Matrix3d inverse = J.inverse();
  return inverse.transpose() * of_sensor * inverse;
}

MatchResult match_result_of_base(const MatchResult& of_sensor,
                                 const Pose2& T_base_sensor_reference,
                                 const Pose2& T_base_sensor_current) {
  const Pose2 T_sensor_base_current = T_base_sensor_current.inverse();
  const auto of_base = [&](const Pose2& T_sensor_sensor) {
    return T_base_sensor_reference * T_sensor_sensor * T_sensor_base_current;
  };
  MatchResult result = of_sensor;
  if (of_sensor.runner_up) {
    result.runner_up->T_reference_current = of_base(of_sensor.runner_up->T_reference_current);
  }
  if (of_sensor.alias) {
    result.alias = T_base_sensor_reference * *of_sensor.alias * T_base_sensor_reference.inverse();
  }
  if (of_sensor.degenerate_direction_rad) {
    const double turned_rad =
        *of_sensor.degenerate_direction_rad + T_base_sensor_reference.theta_rad;
    result.degenerate_direction_rad = turned_rad - kPi * std::floor(turned_rad / kPi);
  }
  if (!of_sensor.T_reference_current) return result;
  result.T_reference_current = of_base(*of_sensor.T_reference_current);

  result.information = information_of_base(of_sensor.information,
                                           *of_sensor.T_reference_current,
                                           T_base_sensor_reference,
                                           T_base_sensor_current);
  return result;
}

}  // namespace setsquare
