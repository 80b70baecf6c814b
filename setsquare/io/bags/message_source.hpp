// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What every recording of messages has in common: ROS 1 bags, rosbag2's SQLite files, MCAP.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "setsquare/core/timestamp.hpp"
#include "setsquare/io/logs/log_reader.hpp"

namespace setsquare {

enum class MessageEncoding {
  kRos1,   ///< ROS 1 serialisation.
  kCdr,    ///< CDR with its header of four bytes (ROS 2).
  kOther,  ///< JSON, Protobuf and others, which are not read.
};

/// A topic of a recording. Two connections with the same name and type are one topic.
struct MessageTopic {
  std::string name;        ///< "/scan".
  std::string type;        ///< "sensor_msgs/LaserScan", without "/msg/" whatever the file says.
  std::string definition;  ///< The type's definition, with those of its parts, as the file has it.
  MessageEncoding encoding = MessageEncoding::kOther;
};

/// One message as it stands in the file.
struct Message {
  std::size_t topic = 0;  ///< Index in MessageSource::topics().
  Timestamp log_time;     ///< When it was recorded.
  std::string_view data;  ///< Serialised; valid until the next read().
  /// Offset in the file of the message, or of the chunk that holds it; in SQLite the row's number.
  std::uint64_t position = 0;
};

/// The messages of a recording, in file order, in bounded memory: that of one chunk.
class MessageSource {
 public:
  using IsWanted = std::function<bool(const MessageTopic&)>;

  virtual ~MessageSource() = default;

  /// Reads the next message of a wanted topic; false at the end. Damage is counted in problems(),
  /// and what can be read behind it is read. Throws FileError where the file cannot be read on.
  [[nodiscard]] virtual bool read(Message& message) = 0;

  /// "ROS 1 bag", "MCAP", "ROS 2 bag (SQLite)".
  [[nodiscard]] virtual std::string format() const = 0;

  /// How much has been read, 0 to 1, where the size is known.
  [[nodiscard]] virtual std::optional<double> fraction_read() const = 0;

  /// Whether log times say when messages came: those of a robot do, those of a file may mean
  /// nothing.
  [[nodiscard]] virtual bool has_arrival_times() const { return false; }

  /// Told of the last message that was read, where it is of no use: damaged, or against what is
  /// known.
  virtual void left_out() {}

  /// Topics met so far, in the order of their first appearance; it grows while reading.
  [[nodiscard]] const std::vector<MessageTopic>& topics() const { return topics_; }

  /// Messages met so far per topic, unwanted ones included where the format tells them without
  /// unpacking what holds none that is wanted.
  [[nodiscard]] const std::vector<std::uint64_t>& num_messages() const { return num_messages_; }

  /// Which topics read() hands on; all by default. Call it before the first read(). It is asked
  /// once per topic, when the topic is met.
  void set_wanted(IsWanted is_wanted) { is_wanted_ = std::move(is_wanted); }

  [[nodiscard]] const LogProblems& problems() const { return problems_; }
  [[nodiscard]] LogProblems& problems() { return problems_; }

 protected:
  /// The index of a topic: that of an equal one (name, type and encoding), or a new one.
  std::size_t add_topic(MessageTopic topic);
  [[nodiscard]] bool is_wanted(std::size_t topic) const { return wanted_[topic]; }
  void count(std::size_t topic, std::uint64_t num_messages = 1) {
    num_messages_[topic] += num_messages;
  }

 private:
  std::vector<MessageTopic> topics_;
  std::vector<std::uint64_t> num_messages_;
  std::vector<bool> wanted_;
  IsWanted is_wanted_;
  LogProblems problems_;
};

/// "sensor_msgs/msg/LaserScan" and "sensor_msgs/LaserScan" to the latter.
[[nodiscard]] std::string plain_type_name(std::string_view type);

}  // namespace setsquare
