// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/sensing/robot_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

constexpr double kTightestArc_m = 0.02;

std::vector<Eigen::Vector2d> without_repeats(const std::vector<Eigen::Vector2d>& route_m) {
  std::vector<Eigen::Vector2d> kept_m;
  for (const Eigen::Vector2d& waypoint_m : route_m) {
    if (!waypoint_m.allFinite()) throw ParameterError("route_m", "a waypoint is not finite");
    if (kept_m.empty() || (waypoint_m - kept_m.back()).norm() > 1e-9) kept_m.push_back(waypoint_m);
  }
  return kept_m;
}

double heading_of(const Eigen::Vector2d& way) { return std::atan2(way.y(), way.x()); }

}  // namespace

void RobotSpeed::validate() const {
  if (!(drive_m_per_s > 0.0) || !std::isfinite(drive_m_per_s)) {
    throw ParameterError("drive_m_per_s", "must be positive");
  }
  if (!(turn_rad_per_s > 0.0) || !std::isfinite(turn_rad_per_s)) {
    throw ParameterError("turn_rad_per_s", "must be positive");
  }
  if (!(corner_radius_m >= 0.0)) throw ParameterError("corner_radius_m", "must not be negative");
}

void TurnAtStart::validate() const {
  if (!std::isfinite(turn_rad)) throw ParameterError("turn_rad", "must be finite");
  if (!(rest_s >= 0.0) || !std::isfinite(rest_s)) {
    throw ParameterError("rest_s", "must not be negative");
  }
}

RobotPath::RobotPath(const std::vector<Eigen::Vector2d>& route_m,
                     const RobotSpeed& speed,
                     const TurnAtStart& turn_at_start)
    : speed_(speed) {
  speed.validate();
  turn_at_start.validate();
  const std::vector<Eigen::Vector2d> corners_m = without_repeats(route_m);
  if (corners_m.empty()) throw ParameterError("route_m", "has no waypoint");

  Eigen::Vector2d at_m = corners_m.front();
  // It ends the turn with the heading in which it drives off.
  const double heading_rad = corners_m.size() > 1 ? heading_of(corners_m[1] - at_m) : 0.0;
  const double first_rad = wrap_to_pi(heading_rad - turn_at_start.turn_rad);
  add_rest({at_m.x(), at_m.y(), first_rad}, turn_at_start.rest_s);
  add_turn(at_m, first_rad, turn_at_start.turn_rad, 0.0);
  add_rest({at_m.x(), at_m.y(), heading_rad}, turn_at_start.rest_s);
  for (std::size_t i = 1; i < corners_m.size(); ++i) {
    const Eigen::Vector2d way = corners_m[i] - corners_m[i - 1];
    const Eigen::Vector2d next_way =
        i + 1 < corners_m.size() ? Eigen::Vector2d(corners_m[i + 1] - corners_m[i]) : way;
    const double turn_rad = wrap_to_pi(heading_of(next_way) - heading_of(way));
    const double tangent = std::abs(std::tan(0.5 * turn_rad));
    double cut_m =
        std::min({speed.corner_radius_m * tangent, 0.5 * way.norm(), 0.5 * next_way.norm()});
    if (cut_m < kTightestArc_m * tangent) cut_m = 0.0;
    const Eigen::Vector2d arc_start_m = corners_m[i] - cut_m * way.normalized();
    add_straight(at_m, heading_of(way), way.normalized().dot(arc_start_m - at_m));
    add_turn(arc_start_m, heading_of(way), turn_rad, cut_m);
    at_m = corners_m[i] + cut_m * next_way.normalized();
  }
  if (pieces_.empty()) pieces_.push_back({.start = {at_m.x(), at_m.y(), 0.0}});
}

void RobotPath::append(Piece piece) {
  piece.start_s = duration_s_;
  piece.route_start_m = route_m_;
  piece.forward = {std::cos(piece.start.theta_rad), std::sin(piece.start.theta_rad)};
  duration_s_ += piece.duration_s;
  length_m_ += piece.duration_s * piece.drive_m_per_s;
  route_m_ += piece.route_m;
  pieces_.push_back(piece);
}

void RobotPath::add_rest(const Pose2& pose, double rest_s) {
  if (rest_s > 0.0) append({.start = pose, .duration_s = rest_s});
}

void RobotPath::add_straight(const Eigen::Vector2d& start_m, double heading_rad, double length_m) {
  if (length_m < 1e-9) return;  // What rounding leaves between two arcs.
  append({.start = {start_m.x(), start_m.y(), heading_rad},
          .duration_s = length_m / speed_.drive_m_per_s,
          .drive_m_per_s = speed_.drive_m_per_s,
          .route_m = length_m});
}

/// A turn that begins `cut_m` before a corner of the route and ends as far behind it.
void RobotPath::add_turn(const Eigen::Vector2d& start_m,
                         double heading_rad,
                         double turn_rad,
                         double cut_m) {
  if (turn_rad == 0.0) return;
  const double angle_rad = std::abs(turn_rad);
  const double radius_m = cut_m > 0.0 ? cut_m / std::tan(0.5 * angle_rad) : 0.0;
  double rate_rad_per_s = speed_.turn_rad_per_s;
  if (cut_m > 0.0) rate_rad_per_s = std::min(rate_rad_per_s, speed_.drive_m_per_s / radius_m);
  append({.start = {start_m.x(), start_m.y(), heading_rad},
          .duration_s = angle_rad / rate_rad_per_s,
          .drive_m_per_s = cut_m > 0.0 ? radius_m * rate_rad_per_s : 0.0,
          .turn_rad_per_s = std::copysign(rate_rad_per_s, turn_rad),
          .route_m = 2.0 * cut_m});
}

Pose2 RobotPath::pose_at(double time_s) const {
  const auto after = std::upper_bound(
      pieces_.begin() + 1, pieces_.end(), time_s, [](double t_s, const Piece& piece) {
        return t_s < piece.start_s;
      });
  const Piece& piece = *(after - 1);
  const double since_s = std::clamp(time_s - piece.start_s, 0.0, piece.duration_s);
  const double turned_rad = piece.turn_rad_per_s * since_s;
  double ahead_m = piece.drive_m_per_s * since_s;
  double left_m = 0.0;
  if (piece.turn_rad_per_s != 0.0 && piece.drive_m_per_s != 0.0) {
    const double radius_m = piece.drive_m_per_s / piece.turn_rad_per_s;
    const double half_sin = std::sin(0.5 * turned_rad);
    ahead_m = radius_m * std::sin(turned_rad);
    left_m = radius_m * 2.0 * half_sin * half_sin;
  }
  return {piece.start.x_m + piece.forward.x() * ahead_m - piece.forward.y() * left_m,
          piece.start.y_m + piece.forward.y() * ahead_m + piece.forward.x() * left_m,
          wrap_to_pi(piece.start.theta_rad + turned_rad)};
}

double RobotPath::time_at_route_distance(double distance_m) const {
  const auto not_before = std::lower_bound(
      pieces_.begin(), pieces_.end(), distance_m, [](const Piece& piece, double at_m) {
        return piece.route_start_m + piece.route_m < at_m;
      });
  if (not_before == pieces_.end()) return duration_s_;
  const double into_m = std::max(distance_m - not_before->route_start_m, 0.0);
  const double share = not_before->route_m > 0.0 ? into_m / not_before->route_m : 0.0;
  return not_before->start_s + share * not_before->duration_s;
}

std::vector<double> sample_times(const RobotPath& path, double distance_m, double angle_rad) {
  if (!(distance_m > 0.0)) throw ParameterError("distance_m", "must be positive");
  if (!(angle_rad > 0.0)) throw ParameterError("angle_rad", "must be positive");
  // Steps short enough that neither motion can come back within one; then bisection.
  const RobotSpeed& speed = path.speed();
  const double step_s =
      0.125 * std::min(distance_m / speed.drive_m_per_s, angle_rad / speed.turn_rad_per_s);
  std::vector<double> times_s{0.0};
  Pose2 last = path.pose_at(0.0);
  const auto has_moved = [&](double time_s) {
    const Pose2 now = path.pose_at(time_s);
    return std::hypot(now.x_m - last.x_m, now.y_m - last.y_m) >= distance_m ||
           std::abs(wrap_to_pi(now.theta_rad - last.theta_rad)) >= angle_rad;
  };
  double before_s = 0.0;
  while (before_s < path.duration_s()) {
    double after_s = std::min(before_s + step_s, path.duration_s());
    if (!has_moved(after_s)) {
      before_s = after_s;
      continue;
    }
    for (int halving = 0; halving < 40; ++halving) {
      const double middle_s = 0.5 * (before_s + after_s);
      (has_moved(middle_s) ? after_s : before_s) = middle_s;
    }
    times_s.push_back(after_s);
    last = path.pose_at(after_s);
    before_s = after_s;
  }
  return times_s;
}

}  // namespace setsquare
