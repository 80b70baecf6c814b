// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Loop closures as lines that robot viewers draw. Apart from the recording, for the message has
// thirty fields of which a line needs six.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>

#include "setsquare/core/timestamp.hpp"
#include "setsquare/io/ros/cdr_writer.hpp"

namespace setsquare {

/// A closure's two ends in the map (m), and whether it is believed.
struct ClosureLine {
  Eigen::Vector2d from_m;
  Eigen::Vector2d to_m;
  bool is_believed = false;
};

/// visualization_msgs/MarkerArray with one list of lines: believed ones blue, outvoted ones red.
void encode_closure_markers(std::span<const ClosureLine> lines,
                            Timestamp stamp,
                            ros::CdrWriter& writer);

/// The definition of visualization_msgs/MarkerArray and of its parts (ROS 2).
[[nodiscard]] std::string closure_marker_definition();

}  // namespace setsquare
