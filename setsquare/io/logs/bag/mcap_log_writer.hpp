// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>

#include "setsquare/io/bags/mcap_writer.hpp"
#include "setsquare/io/logs/log_writer.hpp"
#include "setsquare/io/ros/cdr_writer.hpp"
#include "setsquare/io/ros/messages.hpp"

namespace setsquare {

/// Writes a log as a ROS 2 bag (MCAP): each laser's scans on a topic of its name ("/scan" for the
/// only one of a log that knows no topics), its mounting on /tf_static, odometry on /odom and as
/// the frames odom -> base_link on /tf, true and reference poses on /ground_truth.
///
/// Ranges and bearings become float32, as the message has them; BagLog gives back the decimal
/// numbers that were meant.
class McapLogWriter final : public LogWriter {
 public:
  McapLogWriter(Sink sink, ChunkPacking packing) : file_(std::move(sink), packing) {}

  void write(const LogRecord& record) override;
  void finish() override { file_.finish(); }

 private:
  struct Laser {
    McapWriter::Channel channel = 0;
    std::string frame;
    std::optional<Pose2> T_base_sensor;  ///< As written last.
  };

  void write_scan(const LogRecord& record);
  void write_odometry(const LogRecord& record);
  void write_true_pose(const LogRecord& record);
  void write_mounting(Laser& laser, const LogRecord& record);
  Laser& laser_of(const std::string& sensor);
  template <typename MessageType>
  void write_message(std::optional<McapWriter::Channel>& channel,
                     const std::string& topic,
                     const std::string& type,
                     const MessageType& message,
                     Timestamp stamp);

  McapWriter file_;
  ros::CdrWriter cdr_;
  ros::LaserScan scan_;
  std::map<std::string, Laser> lasers_;  ///< By sensor.
  std::optional<McapWriter::Channel> odometry_;
  std::optional<McapWriter::Channel> transforms_;
  std::optional<McapWriter::Channel> static_transforms_;
  std::optional<McapWriter::Channel> true_poses_;
  std::optional<Timestamp> last_stamp_;  ///< Of the odometry written last.
  Pose2 last_T_odom_base_;
};

}  // namespace setsquare
