// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What every fuzz target shares: its entry point, and the laws that a reader keeps on any bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bags/message_source.hpp"
#include "setsquare/io/logs/log_survey.hpp"
#include "setsquare/io/logs/record_stream.hpp"

/// libFuzzer's entry point, one in each program.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace setsquare::fuzz {

/// An entry point under the name of its file, in the program that has them all (replay.cpp).
using Target = int(const std::uint8_t* data, std::size_t size);
/// "carmen_log" for that of fuzz_carmen_log.cpp; nullptr where there is none.
[[nodiscard]] Target* target_named(std::string_view name);

inline std::string bytes_from(const std::uint8_t* data, std::size_t size) {
  return {data, data + size};
}

/// Ends the program where a law is broken: libFuzzer and CTest both see it.
inline void require(bool is_kept) {
  if (!is_kept) std::abort();
}

/// Reads all records. Laws: a scan has beams and a valid geometry, positions never run backwards,
/// every record that was not damaged can be surveyed.
inline void drain(RecordStream& stream) {
  LogRecord record;
  LogSurvey survey;
  std::uint64_t position = 0;
  while (stream.read(record)) {
    require(record.position >= position);
    position = record.position;
    if (record.kind == RecordKind::kScan) {
      require(record.scan.num_beams() > 0);
      record.scan.validate();
    }
    survey.add(record);
  }
  require(stream.problems().first.size() <= LogProblems::kMaxKept);
}

/// Reads all messages. Laws: a message is of a topic that has been met, its bytes can be read,
/// positions never run backwards, all are counted, and the end stays the end.
inline void drain(MessageSource& source) {
  Message message;
  std::uint64_t position = 0;
  std::uint64_t num_messages = 0;
  while (source.read(message)) {
    require(message.topic < source.topics().size());
    require(message.position >= position);
    position = message.position;
    require(std::string(message.data).size() == message.data.size());
    ++num_messages;
  }
  require(!source.read(message));
  for (const std::uint64_t num_of_topic : source.num_messages()) num_messages -= num_of_topic;
  require(num_messages == 0);
  require(source.problems().first.size() <= LogProblems::kMaxKept);
}

/// Reads the messages of every other topic. Law: those of the others are jumped over.
inline void drain_every_other_topic(MessageSource& source) {
  bool is_wanted = false;
  source.set_wanted([&is_wanted](const MessageTopic&) { return is_wanted = !is_wanted; });
  Message message;
  while (source.read(message)) require(message.topic % 2 == 0);
}

}  // namespace setsquare::fuzz
