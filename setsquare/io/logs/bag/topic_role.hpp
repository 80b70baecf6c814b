// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "setsquare/io/bags/message_source.hpp"

namespace setsquare {

/// What a recording's topic is read for.
enum class TopicRole {
  kNone,  ///< Not read.
  kScan,
  kMultiEchoScan,
  kPoints,  ///< Read where no topic of scans is there, or where it is asked for.
  kOdometry,
  kTransforms,         ///< /tf
  kStaticTransforms,   ///< /tf_static
  kTurnRate,           ///< An inertial unit.
  kReferencePose,      ///< A pose that something else measured: truth, or another program's.
  kReferenceOdometry,  ///< The same as nav_msgs/Odometry, told by "truth" in its name.
};

/// By the topic's type; of odometry, by its name, too.
[[nodiscard]] TopicRole role_of(const MessageTopic& topic);

/// Smaller is more likely what the wheels tell: a topic called "odom" before others, "filtered"
/// ones before visual and laser odometry.
[[nodiscard]] int odometry_rank(std::string_view topic_name);

}  // namespace setsquare
