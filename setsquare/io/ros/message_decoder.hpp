// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "setsquare/io/bags/message_source.hpp"
#include "setsquare/io/ros/decoding_plan.hpp"
#include "setsquare/io/ros/field_columns.hpp"
#include "setsquare/io/ros/messages.hpp"

namespace setsquare::ros {

/// Makes a topic's serialised messages into structs of `messages.hpp`, one decoder per topic:
///
///   MessageDecoder<LaserScan> decoder(topic);
///   const std::string_view fault = decoder.decode(message.data, scan);
///
/// The definition that the recording carries is used; where it carries none, or one that cannot be
/// read, the well-known one of the topic's type (builtin_definitions.hpp).
template <typename MessageType>
class MessageDecoder {
 public:
  explicit MessageDecoder(const MessageTopic& topic);

  /// Why no message of the topic can be decoded; empty if they can.
  [[nodiscard]] const std::string& fault() const { return plan_.fault(); }

  /// Why the recording's own definition is not the one that is used; empty if it is, or if there
  /// is none.
  [[nodiscard]] const std::string& remark() const { return remark_; }

  /// Fills `message`, whose memory is used again. The result is empty, or says why the message
  /// cannot be read; `message` is then half filled.
  [[nodiscard]] std::string_view decode(std::string_view data, MessageType& message);

 private:
  std::string remark_;  // Before plan_, whose making fills it.
  DecodingPlan plan_;
  FieldColumns columns_;
};

extern template class MessageDecoder<LaserScan>;
extern template class MessageDecoder<MultiEchoLaserScan>;
extern template class MessageDecoder<PointCloud2>;
extern template class MessageDecoder<Odometry>;
extern template class MessageDecoder<PoseStamped>;
extern template class MessageDecoder<PoseWithCovarianceStamped>;
extern template class MessageDecoder<Imu>;
extern template class MessageDecoder<TfMessage>;
extern template class MessageDecoder<Path>;
extern template class MessageDecoder<OccupancyGrid>;

}  // namespace setsquare::ros
