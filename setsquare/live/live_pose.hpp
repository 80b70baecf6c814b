// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <memory>
#include <optional>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/timestamp.hpp"
#include "setsquare/grid/occupancy_grid.hpp"
#include "setsquare/localisation/localisation_status.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/map/track_status.hpp"

namespace setsquare {

/// Where the robot is at a scan's stamp, as far as is known at that moment.
struct LivePose {
  Timestamp stamp;
  TrackStatus status = TrackStatus::kTracked;
  bool is_mapped = true;  ///< Else the scan's scanner is not believed yet: the pose is expected.
  /// Whether its place in the map is known: else T_map_base, T_map_odom and the covariance have no
  /// meaning.
  bool is_placed = true;
  Pose2 T_map_base;  ///< Jumps where loops are closed.
  /// By the wheels, where the robot has odometry, else by tracking alone: drifts, never jumps.
  Pose2 T_odom_base;
  bool has_wheels = false;  ///< Whether T_odom_base is by the wheels.
  Pose2 T_map_odom;         ///< T_map_base * T_odom_base^-1
  /// Of T_map_base (x in m, y in m, heading in rad), against the map's first keyframe; of a robot
  /// that is localised, against its walls, and of the sensor.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  std::optional<LocalisationStatus> localisation = {};  ///< In a known map; else nothing.
};

/// The map of the scans so far.
struct LiveMap {
  std::size_t number = 0;  ///< From 1: maps come in order.
  Map map;
  OccupancyGrid grid;
};
using LiveMapPtr = std::shared_ptr<const LiveMap>;

}  // namespace setsquare
