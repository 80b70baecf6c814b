// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz/fuzz_target.hpp"
#include "setsquare/io/logs/json_lines/log.hpp"
#include "setsquare/io/logs/json_lines/writer.hpp"

// Law beyond drain(): what was read can be written, reads back, and is then written the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace setsquare;
  const std::string bytes = fuzz::bytes_from(data, size);
  static_cast<void>(is_json_lines_log(bytes));
  LogOptions options;
  options.scans_only = false;
  JsonLinesLog log(std::make_unique<InputBuffer>(make_memory_source(bytes)), options);
  fuzz::drain(log);
  JsonLinesLog again(std::make_unique<InputBuffer>(make_memory_source(bytes)), options);
  LogRecord record;
  std::string written;
  while (again.read(record)) append_json_record(written, record);
  JsonLinesLog copy(std::make_unique<InputBuffer>(make_memory_source(written)), options);
  std::string rewritten;
  while (copy.read(record)) append_json_record(rewritten, record);
  fuzz::require(rewritten == written);
  return 0;
}
