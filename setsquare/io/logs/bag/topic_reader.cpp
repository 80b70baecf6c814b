// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/logs/bag/topic_reader.hpp"

#include <type_traits>

namespace setsquare {
namespace {

template <typename MessageType>
std::unique_ptr<AnyTopicDecoder> decoder_of(const MessageTopic& topic) {
  return std::make_unique<AnyTopicDecoder>(std::in_place_type<TopicDecoder<MessageType>>, topic);
}

std::unique_ptr<AnyTopicDecoder> decoder_for(TopicRole role, const MessageTopic& topic) {
  switch (role) {
    case TopicRole::kScan:
      return decoder_of<ros::LaserScan>(topic);
    case TopicRole::kMultiEchoScan:
      return decoder_of<ros::MultiEchoLaserScan>(topic);
    case TopicRole::kPoints:
      return decoder_of<ros::PointCloud2>(topic);
    case TopicRole::kOdometry:
    case TopicRole::kReferenceOdometry:
      return decoder_of<ros::Odometry>(topic);
    case TopicRole::kTransforms:
    case TopicRole::kStaticTransforms:
      return decoder_of<ros::TfMessage>(topic);
    case TopicRole::kTurnRate:
      return decoder_of<ros::Imu>(topic);
    case TopicRole::kReferencePose:
      return topic.type == "geometry_msgs/PoseStamped"
                 ? decoder_of<ros::PoseStamped>(topic)
                 : decoder_of<ros::PoseWithCovarianceStamped>(topic);
    case TopicRole::kNone:
      break;
  }
  return std::make_unique<AnyTopicDecoder>();
}

}  // namespace

TopicReader::TopicReader(const MessageTopic& topic)
    : role(role_of(topic)), decoder(decoder_for(role, topic)) {}

std::string TopicReader::fault() const {
  return std::visit(
      [](const auto& any) -> std::string {
        if constexpr (std::is_same_v<std::decay_t<decltype(any)>, std::monostate>) {
          return {};
        } else {
          return any.decoder.fault();
        }
      },
      *decoder);
}

}  // namespace setsquare
