// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz/fuzz_target.hpp"
#include "setsquare/io/logs/csv/log.hpp"
#include "setsquare/io/logs/csv/writer.hpp"

// Laws beyond drain(): what is no table is an error, and a scan that was read can be written.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace setsquare;
  const std::string bytes = fuzz::bytes_from(data, size);
  static_cast<void>(is_csv_log(bytes));
  try {
    CsvLog log(std::make_unique<InputBuffer>(make_memory_source(bytes)), "fuzz");
    fuzz::drain(log);
    CsvLog again(std::make_unique<InputBuffer>(make_memory_source(bytes)), "fuzz");
    LogRecord record;
    std::string table;
    while (again.read(record)) {
      table.clear();
      append_csv_scan(table, record);
    }
  } catch (const FormatError&) {
  }
  return 0;
}
