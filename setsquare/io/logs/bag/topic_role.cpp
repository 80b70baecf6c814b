// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/bag/topic_role.hpp"

#include <algorithm>
#include <array>

namespace setsquare {
namespace {

struct TypeRole {
  std::string_view type;
  TopicRole role;
};

constexpr std::array<TypeRole, 9> kTypeRoles = {
    {{"sensor_msgs/LaserScan", TopicRole::kScan},
     {"sensor_msgs/MultiEchoLaserScan", TopicRole::kMultiEchoScan},
     {"sensor_msgs/PointCloud2", TopicRole::kPoints},
     {"nav_msgs/Odometry", TopicRole::kOdometry},
     {"tf2_msgs/TFMessage", TopicRole::kTransforms},
     {"tf/tfMessage", TopicRole::kTransforms},
     {"sensor_msgs/Imu", TopicRole::kTurnRate},
     {"geometry_msgs/PoseStamped", TopicRole::kReferencePose},
     {"geometry_msgs/PoseWithCovarianceStamped", TopicRole::kReferencePose}}};

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

}  // namespace

TopicRole role_of(const MessageTopic& topic) {
  if (topic.encoding == MessageEncoding::kOther) return TopicRole::kNone;
  const auto* const found =
      std::find_if(kTypeRoles.begin(), kTypeRoles.end(), [&topic](const TypeRole& entry) {
        return entry.type == topic.type;
      });
  if (found == kTypeRoles.end()) return TopicRole::kNone;
  if (found->role == TopicRole::kTransforms && contains(topic.name, "static")) {
    return TopicRole::kStaticTransforms;
  }
  if (found->role == TopicRole::kOdometry && contains(topic.name, "truth")) {
    return TopicRole::kReferenceOdometry;
  }
  return found->role;
}

int odometry_rank(std::string_view topic_name) {
  const std::string_view last = topic_name.substr(topic_name.rfind('/') + 1);
  constexpr std::array<std::string_view, 8> kOfOtherSensors = {
      "visual", "vio", "vo", "laser", "lidar", "icp", "gps", "rtabmap"};
  const bool is_of_other_sensor =
      std::any_of(kOfOtherSensors.begin(), kOfOtherSensors.end(), [&](std::string_view word) {
        return contains(topic_name, word);
      });
  if (is_of_other_sensor) return 3;
  if (last == "odom" || last == "odometry") return 0;
  return contains(topic_name, "odom") ? 1 : 2;
}

}  // namespace setsquare
