// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "setsquare/io/logs/log_reader.hpp"
#include "setsquare/io/ros/cdr_writer.hpp"
#include "setsquare/io/ros/messages.hpp"

namespace setsquare {

/// Where messages of ROS 2 go: a recording, a robot's network.
class MessageSink {
 public:
  using Channel = std::size_t;

  virtual ~MessageSink() = default;
  /// A topic; `type`: "sensor_msgs/msg/LaserScan". `is_latched`: late readers want its last
  /// message, too.
  [[nodiscard]] virtual Channel add_channel(const std::string& topic,
                                            const std::string& type,
                                            bool is_latched) = 0;
  virtual void write(Channel channel, Timestamp stamp, std::string_view cdr) = 0;
};

/// Writes a log's records as the messages of a robot: each laser's scans on a topic of its name
/// ("/scan" for the only one of a log that knows no topics), its mounting on /tf_static, odometry
/// on /odom and as the frames odom -> base_link on /tf, true and reference poses on /ground_truth.
///
/// Ranges and bearings become float32, as the message has them; BagLog gives back the decimal
/// numbers that were meant.
class RosLogWriter {
 public:
  /// The sink must outlive the writer.
  explicit RosLogWriter(MessageSink& sink) : sink_(sink) {}

  /// False where messages have no place for the record. Throws ParameterError (Scan::validate).
  bool write(const LogRecord& record);

 private:
  struct Laser {
    MessageSink::Channel channel = 0;
    std::string frame;
    std::optional<Pose2> T_base_sensor;  ///< As written last.
  };

  void write_scan(const LogRecord& record);
  void write_odometry(const LogRecord& record);
  void write_true_pose(const LogRecord& record);
  void write_mounting(Laser& laser, const LogRecord& record);
  Laser& laser_of(const std::string& sensor);
  template <typename MessageType>
  void write_message(std::optional<MessageSink::Channel>& channel,
                     const std::string& topic,
                     const std::string& type,
                     const MessageType& message,
                     Timestamp stamp);

  MessageSink& sink_;
  ros::CdrWriter cdr_;
  ros::LaserScan scan_;
  std::map<std::string, Laser> lasers_;  ///< By sensor.
  std::optional<MessageSink::Channel> odometry_;
  std::optional<MessageSink::Channel> transforms_;
  std::optional<MessageSink::Channel> static_transforms_;
  std::optional<MessageSink::Channel> true_poses_;
  std::optional<Timestamp> last_stamp_;  ///< Of the odometry written last.
  Pose2 last_T_odom_base_;
};

}  // namespace setsquare
