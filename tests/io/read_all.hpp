// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Sources of bytes for the tests of readers.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bytes/byte_source.hpp"
#include "setsquare/io/logs/open_log.hpp"

namespace setsquare::testing {

/// Delivers at most `num_bytes` at a time, as a slow pipe does.
class TricklingSource final : public ByteSource {
 public:
  TricklingSource(std::string bytes, std::size_t num_bytes)
      : bytes_(std::move(bytes)), num_bytes_(num_bytes) {}

  std::size_t read(std::span<char> into) override {
    const std::size_t count = std::min({num_bytes_, into.size(), bytes_.size() - position_});
    std::copy_n(bytes_.data() + position_, count, into.data());
    position_ += count;
    return count;
  }

 private:
  std::string bytes_;
  std::size_t num_bytes_;
  std::size_t position_ = 0;
};

/// What became of a log: its records, what was wrong, and the error that ended it, if one did.
struct ReadLog {
  std::vector<LogRecord> records;
  LogProblems problems;
  std::string front_sensor;
  std::string error;
};

inline ReadLog read_all(std::unique_ptr<ByteSource> source, const LogOptions& options = {}) {
  ReadLog log;
  try {
    const auto reader = open_log(std::move(source), "test.log", options);
    try {
      while (const LogRecord* record = reader->next()) log.records.push_back(*record);
    } catch (const Error& error) {
      log.error = error.what();
    }
    log.problems = reader->problems();
    log.front_sensor = reader->front_sensor();
  } catch (const Error& error) {
    log.error = error.what();
  }
  return log;
}

inline ReadLog read_all(const std::string& bytes, const LogOptions& options = {}) {
  return read_all(make_memory_source(bytes), options);
}

}  // namespace setsquare::testing
