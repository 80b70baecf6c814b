// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "setsquare/core/pose2.hpp"

namespace setsquare {

/// How fast a robot drives and turns.
struct RobotSpeed {
  double drive_m_per_s = 0.5;
  double turn_rad_per_s = 0.5;   ///< In place and, at most, in corners: it drives slower there.
  double corner_radius_m = 0.4;  ///< Corners of the route are rounded where there is room.

  /// Throws ParameterError where a speed is not positive or the radius is negative.
  void validate() const;
};

/// What a robot does before it drives off: it rests, turns on the spot, and rests.
struct TurnAtStart {
  double turn_rad = 0.0;  ///< Counterclockwise; more than a whole turn, too.
  double rest_s = 0.0;    ///< Before the turn, and behind it.

  /// Throws ParameterError where the turn is not finite or the rest is negative.
  void validate() const;
};

/// Where a robot is at any time: it follows a route of straight pieces, turning at the corners. Its
/// pose is continuous in time and its heading is that of its motion.
class RobotPath {
 public:
  /// Waypoints that repeat the one before are dropped. A corner is an arc that takes at most half
  /// of the shorter piece at either side; where the arc would be tighter than 2 cm (a reversal),
  /// the robot turns in place. A single waypoint: it stands there with heading 0.
  /// Throws ParameterError where the route is empty or not finite.
  explicit RobotPath(const std::vector<Eigen::Vector2d>& route_m,
                     const RobotSpeed& speed = {},
                     const TurnAtStart& turn_at_start = {});

  [[nodiscard]] double duration_s() const { return duration_s_; }
  /// Of the way driven: a little less than the route, whose corners are cut.
  [[nodiscard]] double length_m() const { return length_m_; }
  /// T_map_base at a time; before the start and after the end the robot stands.
  [[nodiscard]] Pose2 pose_at(double time_s) const;
  /// When the robot passes the place at a distance along the route as it was given (the polyline,
  /// corners not rounded); the start and the end for distances beyond them. Where the robot turns
  /// in place: before the turn.
  [[nodiscard]] double time_at_route_distance(double distance_m) const;
  [[nodiscard]] const RobotSpeed& speed() const { return speed_; }

 private:
  /// Straight on, along an arc, or turning in place, all at constant speeds.
  struct Piece {
    Pose2 start;
    double start_s = 0.0;
    double duration_s = 0.0;
    double drive_m_per_s = 0.0;
    double turn_rad_per_s = 0.0;
    double route_start_m = 0.0;  // Along the route as given.
    double route_m = 0.0;
    Eigen::Vector2d forward = Eigen::Vector2d::UnitX();  // Of the start.
  };

  void add_rest(const Pose2& pose, double rest_s);
  void add_straight(const Eigen::Vector2d& start_m, double heading_rad, double length_m);
  void add_turn(const Eigen::Vector2d& start_m, double heading_rad, double turn_rad, double cut_m);
  void append(Piece piece);

  RobotSpeed speed_;
  std::vector<Piece> pieces_;  // Never empty.
  double duration_s_ = 0.0;
  double length_m_ = 0.0;
  double route_m_ = 0.0;
};

/// Times at which the robot is `distance_m` away from where it was at the last one, or has turned
/// by `angle_rad` since then; the first is 0. Throws ParameterError where one is not positive.
[[nodiscard]] std::vector<double> sample_times(const RobotPath& path,
                                               double distance_m,
                                               double angle_rad);

}  // namespace setsquare
