// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz/fuzz_target.hpp"
#include "setsquare/io/logs/carmen/log.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace setsquare;
  const std::string bytes = fuzz::bytes_from(data, size);
  static_cast<void>(is_carmen_log(bytes));
  LogOptions options;
  options.scans_only = false;
  CarmenLog log(std::make_unique<InputBuffer>(make_memory_source(bytes)), options);
  fuzz::drain(log);
  return 0;
}
