// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/io/bags/mcap_writer.hpp"
#include "setsquare/io/logs/bag/ros_log_writer.hpp"
#include "setsquare/io/logs/log_writer.hpp"

namespace setsquare {

/// Writes a log as a ROS 2 bag (MCAP), as RosLogWriter has its messages.
class McapLogWriter final : public LogWriter, private MessageSink {
 public:
  McapLogWriter(Sink sink, ChunkPacking packing)
      : file_(std::move(sink), packing), messages_(*this) {}

  void write(const LogRecord& record) override {
    if (!messages_.write(record)) leave_out();
  }
  void finish() override { file_.finish(); }

 private:
  [[nodiscard]] Channel add_channel(const std::string& topic,
                                    const std::string& type,
                                    bool is_latched) override;
  void write(Channel channel, Timestamp stamp, std::string_view cdr) override {
    file_.write(static_cast<McapWriter::Channel>(channel), stamp, cdr);
  }

  McapWriter file_;
  RosLogWriter messages_;
};

}  // namespace setsquare
