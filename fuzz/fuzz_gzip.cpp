// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz/fuzz_target.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/io/bytes/byte_source.hpp"
#include "setsquare/io/logs/log_survey.hpp"
#include "setsquare/io/logs/open_log.hpp"

// The way of a whole log: gzip or plain, format by content, choice of the laser.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace setsquare;
  try {
    LogOptions options;
    options.scans_only = false;
    const auto reader = open_log(make_memory_source(fuzz::bytes_from(data, size)), "fuzz", options);
    LogSurvey survey;
    while (const LogRecord* record = reader->next()) survey.add(*record);
    fuzz::require(!survey.sensors.empty());  // a log without scans is an error
  } catch (const FormatError&) {
  }
  return 0;
}
