// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Reads recordings to their end, for the tests of their readers.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <compare>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "setsquare/io/bags/message_source.hpp"

namespace setsquare::testing {

struct ReadMessage {
  std::string topic;
  std::int64_t time_ns = 0;
  std::string data;

  bool operator==(const ReadMessage&) const = default;
};

inline std::ostream& operator<<(std::ostream& stream, const ReadMessage& message) {
  return stream << message.topic << " at " << message.time_ns << " (" << message.data.size()
                << " bytes)";
}

struct ReadRecording {
  std::vector<ReadMessage> messages;
  std::vector<MessageTopic> topics;
  std::vector<std::uint64_t> num_messages;
  LogProblems problems;
};

/// Laws on the way: positions never run backwards, and what has ended stays so.
inline ReadRecording read_all_messages(MessageSource& source) {
  ReadRecording recording;
  Message message;
  std::uint64_t position = 0;
  while (source.read(message)) {
    EXPECT_GE(message.position, position);
    position = message.position;
    recording.messages.push_back(
        {source.topics().at(message.topic).name, message.log_time.ns, std::string(message.data)});
  }
  EXPECT_FALSE(source.read(message));
  recording.topics = source.topics();
  recording.num_messages = source.num_messages();
  recording.problems = source.problems();
  return recording;
}

/// How many of `all` are among those read, in order.
inline std::size_t num_found(const std::vector<ReadMessage>& all,
                             const std::vector<ReadMessage>& read) {
  std::size_t num_found = 0;
  auto next = read.begin();
  for (const ReadMessage& message : all) {
    const auto found = std::find(next, read.end(), message);
    if (found == read.end()) continue;
    next = found + 1;
    ++num_found;
  }
  return num_found;
}

}  // namespace setsquare::testing
