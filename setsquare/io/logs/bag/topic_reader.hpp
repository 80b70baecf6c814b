// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// How one topic is read: what for, and by which decoder. Apart from bag_log since only the decoders
// differ from message to message.
#pragma once

#include <memory>
#include <string>
#include <variant>

#include "setsquare/io/bags/message_source.hpp"
#include "setsquare/io/logs/bag/topic_role.hpp"
#include "setsquare/io/ros/message_decoder.hpp"
#include "setsquare/io/ros/messages.hpp"

namespace setsquare {

/// A decoder and the message that it fills, whose memory is used again.
template <typename MessageType>
struct TopicDecoder {
  explicit TopicDecoder(const MessageTopic& topic) : decoder(topic) {}

  ros::MessageDecoder<MessageType> decoder;
  MessageType message;
};

using AnyTopicDecoder = std::variant<std::monostate,
                                     TopicDecoder<ros::LaserScan>,
                                     TopicDecoder<ros::MultiEchoLaserScan>,
                                     TopicDecoder<ros::PointCloud2>,
                                     TopicDecoder<ros::Odometry>,
                                     TopicDecoder<ros::PoseStamped>,
                                     TopicDecoder<ros::PoseWithCovarianceStamped>,
                                     TopicDecoder<ros::Imu>,
                                     TopicDecoder<ros::TfMessage>>;

struct TopicReader {
  explicit TopicReader(const MessageTopic& topic);

  TopicRole role = TopicRole::kNone;
  std::unique_ptr<AnyTopicDecoder> decoder;

  /// Why no message of the topic can be decoded; empty if they can.
  [[nodiscard]] std::string fault() const;
};

}  // namespace setsquare
