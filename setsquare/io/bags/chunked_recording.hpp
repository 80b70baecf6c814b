// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What the readers of recordings of records and chunks share: rosbag1 and mcap.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "setsquare/io/bags/chunked_input.hpp"
#include "setsquare/io/bags/message_source.hpp"

namespace setsquare {

/// A recording read record by record, from its beginning to its end. What is not wanted is jumped
/// over; behind a damaged record, reading goes on at the next place where a record begins.
class ChunkedRecording : public MessageSource {
 public:
  bool read(Message& message) final;
  std::optional<double> fraction_read() const final {
    return input_.file().source().fraction_read();
  }

 protected:
  enum class Step { kMessage, kOther, kEnd };

  /// A message as its record's head describes it.
  struct MessageRecord {
    std::uint32_t channel = 0;
    Timestamp log_time;
    std::uint64_t num_bytes = 0;     ///< Of the whole record.
    std::size_t num_head_bytes = 0;  ///< In front of the message.
  };

  /// `channel_word` is what the format calls a stream of messages of one topic.
  ChunkedRecording(std::unique_ptr<InputBuffer> input, std::string_view channel_word)
      : input_(std::move(input)), channel_word_(channel_word) {}

  /// Reads or passes the next record.
  virtual Step read_record(Message& message) = 0;
  /// Whether a record begins here.
  [[nodiscard]] virtual bool is_record(ByteWindow& bytes) const = 0;
  /// Behind the last record: what the end tells about the recording.
  virtual void report_end() = 0;

  /// Hands on a message of a wanted topic, passes one of another or of an unknown one.
  Step read_message(const MessageRecord& record, Message& message);
  /// Whether a record reaches beyond the uncompressed chunk around it: then its length is wrong,
  /// and reading goes on at the next record.
  bool leaves_chunk(std::uint64_t num_bytes);
  /// Jumps over a record; false where it is cut short.
  bool pass(std::uint64_t num_bytes);
  void resynchronise(const std::string& reason);

  /// False where the channel is known, under whatever name, or one too many.
  bool is_new_channel(std::uint32_t channel, std::string_view topic_name);
  void add_channel_topic(std::uint32_t channel, MessageTopic topic);

  [[nodiscard]] ChunkedInput& input() { return input_; }
  /// The offset in the file where an uncompressed chunk ends that begins here; 0: it is not known.
  void set_end_of_plain_chunk(std::uint64_t offset) { end_of_plain_chunk_ = offset; }
  [[nodiscard]] bool is_known_channel(std::uint32_t channel) const {
    return topic_of_channel_.contains(channel);
  }

 private:
  ChunkedInput input_;
  std::string_view channel_word_;
  std::unordered_map<std::uint32_t, std::size_t> topic_of_channel_;
  std::size_t num_bytes_of_message_ = 0;  ///< What the last read() handed on.
  std::uint64_t end_of_plain_chunk_ = 0;
  bool is_ended_ = false;
};

}  // namespace setsquare
