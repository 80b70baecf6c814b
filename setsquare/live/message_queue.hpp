// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setsquare/io/bags/message_source.hpp"

namespace setsquare {

/// Messages that come while the robot drives, from any threads, as a recording that is read: what
/// maps a bag maps a robot. Memory is bounded: where the reader falls behind, the oldest messages
/// are dropped, and counted.
class MessageQueue final : public MessageSource {
 public:
  static constexpr std::size_t kMaxMessages = 4096;
  static constexpr std::size_t kMaxBytes = 64U << 20U;

  using Clock = std::chrono::steady_clock;
  /// Told of each message that read() gives, on its thread.
  using OnRead = std::function<void(const MessageTopic&, const Message&)>;

  /// `format`: what the messages come by, "ROS 2".
  explicit MessageQueue(std::string format) : format_(std::move(format)) {}

  /// A topic whose messages may come; before the first push(). `topic.type` is without "/msg/".
  [[nodiscard]] std::size_t add(MessageTopic topic) { return add_topic(std::move(topic)); }
  void on_read(OnRead call) { on_read_ = std::move(call); }

  // Called by any thread.

  /// A message that came now. `log_time`: by the clock of the world.
  void push(std::size_t topic, Timestamp log_time, std::string_view data);
  /// No more comes: read() gives what is left, and then the end.
  void close();
  /// Messages that came and are not yet read.
  [[nodiscard]] std::size_t num_waiting() const;
  /// Messages that were dropped.
  [[nodiscard]] std::uint64_t num_dropped() const;
  /// Messages that were read and were of no use.
  [[nodiscard]] std::uint64_t num_left_out() const { return num_left_out_; }

  // The reader.

  /// Waits for a message.
  [[nodiscard]] bool read(Message& message) override;
  [[nodiscard]] std::string format() const override { return format_; }
  [[nodiscard]] std::optional<double> fraction_read() const override { return std::nullopt; }
  [[nodiscard]] bool has_arrival_times() const override { return true; }
  void left_out() override { ++num_left_out_; }
  /// When the last message that was read came.
  [[nodiscard]] Clock::time_point arrival() const { return current_.arrival; }

 private:
  struct Queued {
    std::size_t topic = 0;
    Timestamp log_time;
    Clock::time_point arrival;
    std::string data;
  };

  std::string format_;
  OnRead on_read_;
  Queued current_;
  std::uint64_t num_read_ = 0;
  std::atomic<std::uint64_t> num_left_out_ = 0;

  mutable std::mutex mutex_;  ///< All below.
  std::condition_variable has_more_;
  std::deque<Queued> queued_;
  std::size_t num_bytes_ = 0;
  std::uint64_t num_dropped_ = 0;
  bool is_closed_ = false;
};

}  // namespace setsquare
