// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/keyframe_track.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <Eigen/LU>
#include <set>

#include "setsquare/mapping/open_spread.hpp"

namespace setsquare {
namespace {

/// The motion from keyframe k - 1 to k. `covariance_m2`: of its translation in the map frame;
/// `heading_rad`: of keyframe k - 1.
Constraint motion_constraint(const KeyframeTrack& track,
                             std::size_t k,
                             const Pose2& T_from_to,
                             const Eigen::Matrix2d& covariance_m2,
                             double heading_rad) {
  const Eigen::Matrix2d R = rotation_matrix(-heading_rad);
  Constraint constraint;
  constraint.from = k - 1;
  constraint.to = k;
  constraint.T_from_to = T_from_to;
  constraint.information.setZero();
  constraint.information.topLeftCorner<2, 2>() = (R * covariance_m2 * R.transpose()).inverse();
  constraint.information(2, 2) = 1.0 / track.motions[k].rotation_rad2;
  return constraint;
}

/// Of each keyframe: how far the map's frame is turned against the odom frame there.
std::vector<double> drifts_rad(const KeyframeTrack& track, std::span<const double> headings_rad) {
  std::vector<double> drifts_rad;
  for (std::size_t k = 0; k < track.size(); ++k) {
    drifts_rad.push_back(headings_rad[k] - track.keyframes[k]->T_odom_sensor.theta_rad);
  }
  return drifts_rad;
}

/// The pose `share` of the way from a to b.
Pose2 between(const Pose2& a, const Pose2& b, double share) {
  return {a.x_m + share * (b.x_m - a.x_m),
          a.y_m + share * (b.y_m - a.y_m),
          wrap_to_pi(a.theta_rad + share * wrap_to_pi(b.theta_rad - a.theta_rad))};
}

/// How much of what tracking is off by from the first of two and more poses to the last lies, as
/// far as one can tell, before each: as the squares of ways and turns. Where nothing moves, as the
/// scans.
std::vector<double> shares_of_error(std::span<const Pose2> T_odom_sensor) {
  constexpr double kLever_m = 1.0;  // A turn by 1 rad counts as this way.
  std::vector<double> shares{0.0};
  for (std::size_t i = 1; i < T_odom_sensor.size(); ++i) {
    const Pose2 step = T_odom_sensor[i - 1].inverse() * T_odom_sensor[i];
    const double turn_m = kLever_m * step.theta_rad;
    shares.push_back(shares.back() + step.x_m * step.x_m + step.y_m * step.y_m + turn_m * turn_m);
  }
  const double whole = shares.back();
  const auto num_steps = static_cast<double>(shares.size() - 1);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const bool moves = whole > 0.0 && std::isfinite(whole);
    shares[i] = moves ? shares[i] / whole : static_cast<double>(i) / num_steps;
  }
  return shares;
}

}  // namespace

std::size_t KeyframeTrack::num_scanners() const {
  std::set<std::uint32_t> scanners;
  for (const KeyframePtr& keyframe : keyframes) scanners.insert(keyframe->scan->scanner);
  return std::max<std::size_t>(1, scanners.size());
}

std::size_t keyframe_of_scan(const KeyframeTrack& track, std::size_t scan_index) {
  const auto found =
      std::ranges::lower_bound(track.keyframes, scan_index, {}, [](const KeyframePtr& keyframe) {
        return keyframe->scan_index;
      });
  assert(found != track.keyframes.end() && (*found)->scan_index == scan_index);
  return static_cast<std::size_t>(found - track.keyframes.begin());
}

std::vector<double> ways_m_of(const KeyframeTrack& track) {
  std::vector<double> ways_m(track.size(), 0.0);
  for (std::size_t k = 1; k < track.size(); ++k) {
    const Pose2 moved =
        track.keyframes[k - 1]->T_odom_body.inverse() * track.keyframes[k]->T_odom_body;
    ways_m[k] = ways_m[k - 1] + std::hypot(moved.x_m, moved.y_m);
  }
  return ways_m;
}

std::vector<ScanSurfacesPtr> surfaces_of(const KeyframeTrack& track) {
  std::vector<ScanSurfacesPtr> surfaces;
  surfaces.reserve(track.size());
  for (const KeyframePtr& keyframe : track.keyframes) surfaces.push_back(keyframe->surfaces);
  return surfaces;
}

PoseGraph pose_graph_of(const KeyframeTrack& track, std::span<const double> headings_rad) {
  assert(headings_rad.size() == track.size());
  const std::vector<double> drift_rad = drifts_rad(track, headings_rad);
  std::vector<double> turns_rad;
  for (std::size_t k = 0; k < track.size(); ++k) {
    const double before_rad = drift_rad[k == 0 ? 0 : k - 1];
    turns_rad.push_back(before_rad + 0.5 * wrap_to_pi(drift_rad[k] - before_rad));
  }
  const std::vector<Eigen::Matrix2d> covariances_m2 = motion_covariances_m2(track, turns_rad);
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
    const Eigen::Vector2d moved_m =
        rotation_matrix(turns_rad[k]) * (T_odom_sensor.translation() - T_odom_before.translation());
    const Eigen::Vector2d seen_m = rotation_matrix(-T_map_before.theta_rad) * moved_m;
    graph.constraints.push_back(motion_constraint(
        track,
        k,
        {seen_m.x(), seen_m.y(), wrap_to_pi(T_odom_sensor.theta_rad - T_odom_before.theta_rad)},
        covariances_m2[k],
        T_map_before.theta_rad));
    graph.T_map_node.push_back(
        {T_map_before.x_m + moved_m.x(), T_map_before.y_m + moved_m.y(), heading_rad});
  }
  return graph;
}

std::vector<Pose2> assemble_track(std::span<const Pose2> T_odom_sensor,
                                  std::span<const MappedKeyframe> keyframes) {
  std::vector<Pose2> T_map_sensor(T_odom_sensor.begin(), T_odom_sensor.end());
  if (keyframes.empty()) return T_map_sensor;
  const auto seen_from = [&](const MappedKeyframe& keyframe, std::size_t i) {
    return keyframe.T_map_sensor *
           (T_odom_sensor[keyframe.scan_index].inverse() * T_odom_sensor[i]);
  };
  for (std::size_t i = 0; i < keyframes.front().scan_index; ++i) {
    T_map_sensor[i] = seen_from(keyframes.front(), i);
  }
  for (std::size_t k = 0; k < keyframes.size(); ++k) {
    const MappedKeyframe& from = keyframes[k];
    const bool is_last = k + 1 == keyframes.size();
    const std::size_t end = is_last ? T_odom_sensor.size() : keyframes[k + 1].scan_index;
    if (is_last || keyframes[k + 1].begins_piece) {
      for (std::size_t i = from.scan_index; i < end; ++i) T_map_sensor[i] = seen_from(from, i);
      continue;
    }
    const MappedKeyframe& to = keyframes[k + 1];
    const std::vector<double> shares =
        shares_of_error(T_odom_sensor.subspan(from.scan_index, end + 1 - from.scan_index));
    for (std::size_t i = from.scan_index; i < end; ++i) {
      T_map_sensor[i] = between(seen_from(from, i), seen_from(to, i), shares[i - from.scan_index]);
    }
  }
  return T_map_sensor;
}

}  // namespace setsquare
