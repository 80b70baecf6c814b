// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bags/chunked_recording.hpp"

#include <fmt/core.h>

#include <utility>

namespace setsquare {
namespace {

/// A recording has a few hundred channels; a file that describes more than this is damaged.
constexpr std::size_t kMaxChannels = 1 << 14;

}  // namespace

bool ChunkedRecording::read(Message& message) {
  input_.next_record().consume(std::exchange(num_bytes_of_message_, 0));
  while (!is_ended_) {
    const Step step = read_record(message);
    if (step == Step::kMessage) return true;
    is_ended_ = step == Step::kEnd;
    if (is_ended_) report_end();
  }
  return false;
}

ChunkedRecording::Step ChunkedRecording::read_message(const MessageRecord& record,
                                                      Message& message) {
  const auto channel = topic_of_channel_.find(record.channel);
  if (channel == topic_of_channel_.end()) {
    problems().add(
        input_.location(),
        fmt::format("a message of {} {}, which is not described", channel_word_, record.channel));
    pass(record.num_bytes);
    return Step::kOther;
  }
  const std::size_t topic = channel->second;
  if (!is_wanted(topic)) {
    if (pass(record.num_bytes)) count(topic);
    return Step::kOther;
  }
  ByteWindow& bytes = input_.next_record();
  const auto num_bytes = static_cast<std::size_t>(record.num_bytes);
  if (!bytes.ensure(num_bytes)) {
    resynchronise("a message is cut short");
    return Step::kOther;
  }
  count(topic);
  message.topic = topic;
  message.log_time = record.log_time;
  message.data = bytes.available().substr(record.num_head_bytes, num_bytes - record.num_head_bytes);
  message.position = input_.position();
  num_bytes_of_message_ = num_bytes;
  return Step::kMessage;
}

bool ChunkedRecording::leaves_chunk(std::uint64_t num_bytes) {
  const std::uint64_t offset = input_.next_record().offset();
  const bool is_in_plain_chunk = !input_.is_in_chunk() && offset < end_of_plain_chunk_;
  if (!is_in_plain_chunk || offset + num_bytes <= end_of_plain_chunk_) return false;
  resynchronise("a message reaches beyond its chunk");
  return true;
}

bool ChunkedRecording::pass(std::uint64_t num_bytes) {
  ByteWindow& bytes = input_.next_record();
  const std::uint64_t offset = bytes.offset();
  if (bytes.skip(num_bytes) == num_bytes) return true;
  problems().add(input_.location(offset), "a record is cut short");
  return false;
}

void ChunkedRecording::resynchronise(const std::string& reason) {
  problems().add(input_.location(), reason);
  input_.find_record([this](ByteWindow& bytes) { return is_record(bytes); });
}

bool ChunkedRecording::is_new_channel(std::uint32_t channel, std::string_view topic_name) {
  const auto known = topic_of_channel_.find(channel);
  if (known != topic_of_channel_.end()) {
    if (topics()[known->second].name != topic_name) {
      problems().add(input_.location(),
                     fmt::format("{} {} is described again, as another", channel_word_, channel));
    }
    return false;
  }
  if (topic_of_channel_.size() < kMaxChannels) return true;
  problems().add(input_.location(), fmt::format("too many {}s", channel_word_));
  return false;
}

void ChunkedRecording::add_channel_topic(std::uint32_t channel, MessageTopic topic) {
  topic_of_channel_.emplace(channel, add_topic(std::move(topic)));
}

}  // namespace setsquare
