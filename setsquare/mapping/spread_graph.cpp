// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/spread_graph.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/headings/heading_params.hpp"
#include "setsquare/mapping/audit/unseconded_steps.hpp"

namespace setsquare {
namespace {

/// A frame of the building that fewer keyframes see tells nothing of its wings.
constexpr double kMinSupport = HeadingFramesParams{}.min_support;

/// How far a wrong step among key frames is off (sigma): places that look alike are metres apart,
/// and turned by up to a half turn against each other.
constexpr double kWrongStep_m = 2.0;
constexpr double kWrongStep_rad = rad_from_deg(60.0);
/// The same where odometry that is believed tells the step as well.
constexpr double kWrongStepByOdometry_m = 0.3;
constexpr double kWrongStepByOdometry_rad = rad_from_deg(4.0);

bool is_open(const Map& map, std::size_t node) {
  return map.scans[map.keyframes[node]].is_turn_open;
}

/// Turns that the walls leave open, from keyframe to keyframe.
struct OpenTurns {
  std::vector<double> variance_rad2;  ///< What the motion to each keyframe adds.
  std::vector<double> run_rad;        ///< Sigma of the run of open turns up to each keyframe.
};

/// Errors of scans in a row are one error: sigmas add up from scan to scan, and each motion between
/// keyframes gets what it adds to the variance of the whole.
OpenTurns open_turns(const Map& map) {
  OpenTurns turns;
  double sum_rad = 0.0;
  double at_keyframe_rad2 = 0.0;
  double ended_rad2 = 0.0;
  std::size_t scan = 0;
  for (const std::size_t keyframe : map.keyframes) {
    double run_rad = 0.0;
    for (; scan <= keyframe; ++scan) {
      const MappedScan& mapped = map.scans[scan];
      sum_rad += mapped.open_turn_sigma_rad;
      run_rad = std::max(run_rad, sum_rad);
      if (mapped.is_turn_open || mapped.status == TrackStatus::kLost) continue;
      ended_rad2 += sum_rad * sum_rad - at_keyframe_rad2;
      sum_rad = at_keyframe_rad2 = 0.0;
    }
    turns.variance_rad2.push_back(ended_rad2 + sum_rad * sum_rad - at_keyframe_rad2);
    turns.run_rad.push_back(run_rad);
    at_keyframe_rad2 = sum_rad * sum_rad;
    ended_rad2 = 0.0;
  }
  return turns;
}

/// How a turn by 1 rad about the middle, seen by the last scan at or before a keyframe whose turn
/// is open, moves the robot at the keyframe (x, y, theta), in the map.
Eigen::Vector3d open_motion(const Map& map, std::size_t keyframe) {
  std::size_t seen = keyframe;
  while (seen > 0 && !map.scans[seen].is_turn_open) --seen;
  const MappedScan& scan = map.scans[seen];
  const Eigen::Vector2d to_robot_m =
      map.scans[keyframe].T_map_base.translation() - scan.T_map_sensor.translation();
  const Eigen::Vector2d moved_m =
      scan.open_turn_motion_m + Eigen::Vector2d(-to_robot_m.y(), to_robot_m.x());
  return {moved_m.x(), moved_m.y(), 1.0};
}

/// Adds the open turn to the covariance of the motion to a keyframe.
void open_step(const Map& map, double variance_rad2, Constraint& step) {
  Eigen::Vector3d motion = open_motion(map, map.keyframes[step.to]);
  motion.head<2>() = rotation_matrix(-map.graph.T_map_node[step.from].theta_rad) * motion.head<2>();
  const Eigen::Vector3d bound = step.information * motion;
  step.information -= bound * bound.transpose() / (1.0 / variance_rad2 + motion.dot(bound));
}

bool is_told_by_odometry(const Map& map, std::size_t keyframe) {
  const OdometryVerdict verdict = map.odometry.verdict;
  return (verdict == OdometryVerdict::kBelieved || verdict == OdometryVerdict::kScaled) &&
         keyframe < map.track.motions.size() && map.track.motions[keyframe].covariance.has_odometry;
}

/// Adds to the covariance of a step.
void widen(double sigma_m, double sigma_rad, Constraint& step) {
  const Eigen::Vector3d variances(sigma_m * sigma_m, sigma_m * sigma_m, sigma_rad * sigma_rad);
  const Eigen::Matrix3d bound = Eigen::Matrix3d(variances.asDiagonal()) * step.information;
  step.information *= (Eigen::Matrix3d::Identity() + bound).inverse();
}

/// Whether a closure ties keyframes on both sides of one of the steps, a few steps from each other.
bool ties_across(const Constraint& constraint, std::span<const std::size_t> steps) {
  const auto [first, last] = std::minmax(constraint.from, constraint.to);
  if (constraint.kind != ConstraintKind::kLoopClosure || last - first > kMaxSecondingSteps) {
    return false;
  }
  return std::ranges::any_of(steps, [&](std::size_t step) { return first < step && step <= last; });
}

/// Makes the steps that departed from the odometry as uncertain as scans and odometry differ.
void widen_departures(const Map& map, PoseGraph& graph) {
  if (map.track.motions.size() != map.keyframes.size()) return;
  for (Constraint& step : graph.constraints) {
    if (!is_tracked_step(step)) continue;
    const MotionCovariance& motion = map.track.motions[step.to].covariance;
    if (!(motion.departure_sigma_m + motion.departure_sigma_rad > 0.0)) continue;
    widen(motion.departure_sigma_m, motion.departure_sigma_rad, step);
  }
}

/// How certain a turn must be (sigma) for walls to tell the heading behind it: three of these are
/// half of the least angle that walls of the building stand at to each other, be it the quarter.
double sure_turn_rad(const std::vector<BuildingFrame>& frames) {
  double least_rad = kQuarterTurn;
  for (std::size_t f = 1; f < frames.size(); ++f) {
    for (std::size_t g = 0; g < f; ++g) {
      if (std::min(frames[f].support, frames[g].support) < kMinSupport) continue;
      const double angle_rad =
          wrap_to_period(frames[f].offset_rad - frames[g].offset_rad, kQuarterTurn);
      least_rad = std::min(least_rad, std::abs(angle_rad));
    }
  }
  return least_rad / 6.0;
}

/// For each keyframe how often the turn was lost before it.
std::vector<std::size_t> sure_parts(const PoseGraph& graph,
                                    std::size_t num_keyframes,
                                    const OpenTurns& turns,
                                    double sure_rad) {
  std::vector<std::size_t> parts(num_keyframes, 0);
  for (const Constraint& step : graph.constraints) {
    if (!is_tracked_step(step)) continue;
    const double information = step.information(2, 2);
    if (!(information * sure_rad * sure_rad > 1.0)) parts[step.to] = 1;
  }
  for (std::size_t k = 1; k < parts.size(); ++k) {
    const bool is_lost = turns.run_rad[k] > sure_rad;
    parts[k] = parts[k - 1] + (parts[k] > 0 || is_lost ? 1 : 0);
  }
  return parts;
}

}  // namespace

StepReach wrong_step_sigma(const Map& map, std::size_t keyframe) {
  if (!is_told_by_odometry(map, keyframe)) return {kWrongStep_m, kWrongStep_rad};
  return {kWrongStepByOdometry_m, kWrongStepByOdometry_rad};
}

bool is_tracked_step(const Constraint& constraint) {
  return constraint.kind == ConstraintKind::kOdometry && constraint.to == constraint.from + 1;
}

PoseGraph spread_graph(const Map& map, std::span<const std::size_t> unseconded) {
  PoseGraph graph = map.graph;
  if (map.keyframes.size() != graph.T_map_node.size()) return graph;
  std::erase_if(graph.constraints, [&](const Constraint& constraint) {
    return constraint.kind == ConstraintKind::kLoopClosure &&
           (is_open(map, constraint.from) || is_open(map, constraint.to));
  });
  std::erase_if(graph.headings,
                [&](const HeadingMeasurement& heading) { return is_open(map, heading.node); });
  widen_departures(map, graph);
  const OpenTurns turns = open_turns(map);
  for (Constraint& step : graph.constraints) {
    if (!is_tracked_step(step) || !(turns.variance_rad2[step.to] > 0.0)) continue;
    open_step(map, turns.variance_rad2[step.to], step);
  }
  std::erase_if(graph.constraints,
                [&](const Constraint& constraint) { return ties_across(constraint, unseconded); });
  for (Constraint& step : graph.constraints) {
    const bool is_doubtful =
        is_tracked_step(step) && std::ranges::find(unseconded, step.to) != unseconded.end();
    if (!is_doubtful) continue;
    const StepReach off = wrong_step_sigma(map, step.to);
    widen(off.distance_m, off.turn_rad, step);
  }
  const std::vector<std::size_t> parts =
      sure_parts(graph, map.keyframes.size(), turns, sure_turn_rad(map.frames));
  if (parts.empty() || parts.back() == 0) return graph;
  std::vector<double> information(parts.back() + 1, 0.0);
  for (const HeadingMeasurement& heading : graph.headings) {
    information[parts[heading.node]] += heading.information_per_rad2;
  }
  const auto best = static_cast<std::size_t>(
      std::max_element(information.begin(), information.end()) - information.begin());
  std::erase_if(graph.headings,
                [&](const HeadingMeasurement& heading) { return parts[heading.node] != best; });
  return graph;
}

}  // namespace setsquare
