// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// ROS 2 messages written, for recordings that others open and for the live node.
#pragma once

#include "setsquare/io/ros/cdr_writer.hpp"
#include "setsquare/io/ros/messages.hpp"

namespace setsquare::ros {

// Each writes a whole message, header included, and replaces what the writer held. The bytes fit
// builtin_definition() of the type. What the struct leaves out is written as zeros: covariances,
// intensities. Numbers that a float32 cannot hold become infinite.

void encode(const LaserScan& scan, CdrWriter& writer);
void encode(const Odometry& odometry, CdrWriter& writer);
void encode(const TfMessage& message, CdrWriter& writer);
void encode(const PoseStamped& pose, CdrWriter& writer);
void encode(const PoseWithCovarianceStamped& pose, CdrWriter& writer);
void encode(const Path& path, CdrWriter& writer);
void encode(const DiagnosticArray& diagnostics, CdrWriter& writer);

/// The map's load time is written as its stamp.
void encode(const OccupancyGrid& grid, CdrWriter& writer);
/// nav_msgs/MapMetaData alone.
void encode_metadata(const OccupancyGrid& grid, CdrWriter& writer);

}  // namespace setsquare::ros
