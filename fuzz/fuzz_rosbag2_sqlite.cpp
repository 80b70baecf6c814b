// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz/fuzz_target.hpp"
#include "setsquare/io/bags/rosbag2_sqlite.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace setsquare;
  try {
    Rosbag2Sqlite source(make_memory_source(fuzz::bytes_from(data, size)), "fuzz");
    fuzz::drain(source);
  } catch (const FormatError&) {
  }
  return 0;
}
