// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from bag_log, its only user: which frames are the robot's and its scanners' is a question
// of its own.
#pragma once

#include <cstddef>
#include <Eigen/Geometry>
#include <map>
#include <string>
#include <string_view>

#include "setsquare/core/timestamp.hpp"
#include "setsquare/io/ros/transform_tree.hpp"

namespace setsquare {

/// The frames of a recording: which one is the robot, and where on it scanners sit.
class RobotFrames {
 public:
  /// A mounting that placed so many scans one after the other is held (TransformTree::hold).
  static constexpr std::size_t kNumScansToHold = 50;
  /// A frame that was silent for so long may be another's.
  static constexpr double kSilent_s = 3.0;

  ros::TransformFault add(const ros::TransformStamped& transform, bool is_static) {
    return is_static ? tree_.add_static(transform) : tree_.add(transform);
  }

  /// Whether a moving transform must go on from the last one: the robot's own motion must, and that
  /// of what carries a scanner. Wheels and arms may do as they like, and a map may jump.
  [[nodiscard]] bool must_go_on(const ros::TransformStamped& transform) const;

  /// Whether a moving transform is the odometry's, of the robot: of several frames in odom one is.
  [[nodiscard]] bool is_odometry(const ros::TransformStamped& transform, Timestamp log_time);

  /// Whether a frame is one of the robot's.
  [[nodiscard]] bool is_known(std::string_view frame) const;

  /// Where a scanner sits, in the odometry's base frame where that is known and reaches it, else in
  /// the frame that looks most like the robot's. Moving frames are taken as they were at most
  /// `max_outside_s` away from the stamp.
  [[nodiscard]] ros::TransformLookup mounting_of(const std::string& frame,
                                                 const std::string& odometry_base,
                                                 Timestamp stamp,
                                                 double max_outside_s) const;

  /// A scan of the frame was placed.
  void add_placed(const std::string& frame,
                  const std::string& odometry_base,
                  const Eigen::Isometry3d& T_base_sensor);

  [[nodiscard]] const ros::TransformTree& tree() const { return tree_; }

 private:
  /// How many scans of a frame were placed alike, one after the other.
  struct Standing {
    Eigen::Matrix4d T_base_sensor = Eigen::Matrix4d::Zero();
    std::size_t num_scans = 0;
  };

  [[nodiscard]] std::string base_frame_of(const std::string& frame) const;

  ros::TransformTree tree_;
  std::string robot_;  ///< In the odometry's frame.
  Timestamp last_robot_;
  std::map<std::string, Standing> standing_;  ///< By the scanner's frame.
};

}  // namespace setsquare
