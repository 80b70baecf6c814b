// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Keyframes in walled worlds without a tracker: their poses are given.
#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "setsquare/mapping/keyframe_track.hpp"
#include "tests/support/simulated_drive.hpp"

namespace setsquare::testing {

inline constexpr Fan kAllAround{360, -kPi, kTwoPi / 360.0};

/// Some of a drive's poses: each at least this far, or turned this far, from the one before.
inline std::vector<Pose2> spaced(const std::vector<Pose2>& poses,
                                 double distance_m = 0.4,
                                 double turn_rad = rad_from_deg(10.0)) {
  std::vector<Pose2> kept{poses.front()};
  for (const Pose2& pose : poses) {
    const Pose2 moved = between(kept.back(), pose);
    const bool is_far = std::hypot(moved.x_m, moved.y_m) >= distance_m - 1e-9;
    if (is_far || std::abs(moved.theta_rad) >= turn_rad - 1e-9) kept.push_back(pose);
  }
  return kept;
}

/// A single keyframe without its neighbours.
inline KeyframePtr make_keyframe(const Scan& scan, const Pose2& T_odom_sensor, std::size_t index) {
  return std::make_shared<Keyframe>(Keyframe{.scan_index = index,
                                             .T_odom_sensor = T_odom_sensor,
                                             .T_odom_body = T_odom_sensor,
                                             .scan = std::make_shared<const Scan>(scan),
                                             .surfaces = scan_surfaces(scan)});
}

/// A small motion's covariance.
inline MotionCovariance small_covariance() {
  return {.translation_m2 = 6.4e-5 * Eigen::Matrix2d::Identity(), .rotation_rad2 = 4e-6};
}

/// Keyframes at these poses, tracked exactly: the odom frame is the world. One stretch, one piece.
inline KeyframeTrack track_in_world(const std::vector<Wall>& walls,
                                    const std::vector<Pose2>& T_world_sensor,
                                    double noise_m,
                                    const Fan& fan = kAllAround,
                                    std::size_t first_seed = 1) {
  KeyframeTrack track;
  for (std::size_t k = 0; k < T_world_sensor.size(); ++k) {
    const Scan scan = scan_of_walls(walls, T_world_sensor[k], fan, noise_m, first_seed + k);
    track.keyframes.push_back(make_keyframe(scan, T_world_sensor[k], k));
    track.motions.push_back(small_covariance());
    track.stretches.push_back(0);
    track.pieces.push_back(0);
  }
  return track;
}

/// A corridor 2 m wide around a block of 12 m x 8 m, its outer walls 16 m x 12 m from (0, 0), with
/// niches and posts that distinguish its sides and corners.
inline std::vector<Wall> corridor_around_a_block() {
  return {{0.0, 0.0, 16.0, 0.0},   {16.0, 0.0, 16.0, 12.0}, {16.0, 12.0, 0.0, 12.0},
          {0.0, 12.0, 0.0, 0.0},   {2.0, 2.0, 14.0, 2.0},   {14.0, 2.0, 14.0, 10.0},
          {14.0, 10.0, 2.0, 10.0}, {2.0, 10.0, 2.0, 2.0},   {4.0, 0.0, 4.0, 0.4},
          {4.0, 0.4, 5.5, 0.4},    {5.5, 0.4, 5.5, 0.0},    {9.0, 0.0, 9.0, 0.3},
          {9.0, 0.3, 9.6, 0.3},    {9.6, 0.3, 9.6, 0.0},    {16.0, 4.0, 15.6, 4.0},
          {15.6, 4.0, 15.6, 4.7},  {15.6, 4.7, 16.0, 4.7},  {14.0, 7.0, 14.3, 7.0},
          {14.3, 7.0, 14.3, 8.2},  {14.3, 8.2, 14.0, 8.2},  {11.0, 12.0, 11.0, 11.7},
          {11.0, 11.7, 9.8, 11.7}, {9.8, 11.7, 9.8, 12.0},  {5.0, 10.0, 5.0, 10.3},
          {5.0, 10.3, 4.0, 10.3},  {4.0, 10.3, 4.0, 10.0},  {0.0, 8.0, 0.4, 8.0},
          {0.4, 8.0, 0.4, 7.1},    {0.4, 7.1, 0.0, 7.1},    {2.0, 4.5, 1.7, 4.5},
          {1.7, 4.5, 1.7, 3.8},    {1.7, 3.8, 2.0, 3.8}};
}

/// Around the block, and half of it again.
inline std::vector<Eigen::Vector2d> way_around_the_block() {
  return {{1.0, 1.0}, {15.0, 1.0}, {15.0, 11.0}, {1.0, 11.0}, {1.0, 1.0}, {15.0, 1.0}, {15.0, 6.0}};
}

/// The walls, moved.
inline std::vector<Wall> moved(std::vector<Wall> walls, const Pose2& T) {
  for (Wall& wall : walls) {
    const Eigen::Vector2d a = T * Eigen::Vector2d(wall.x1_m, wall.y1_m);
    const Eigen::Vector2d b = T * Eigen::Vector2d(wall.x2_m, wall.y2_m);
    wall = {a.x(), a.y(), b.x(), b.y()};
  }
  return walls;
}

}  // namespace setsquare::testing
