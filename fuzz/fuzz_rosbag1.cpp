// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz/fuzz_target.hpp"
#include "setsquare/io/bags/rosbag1.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace setsquare;
  const std::string bytes = fuzz::bytes_from(data, size);
  const auto read = [&](bool are_some_unwanted) {
    Rosbag1 source(std::make_unique<InputBuffer>(make_memory_source(bytes)), "fuzz");
    are_some_unwanted ? fuzz::drain_every_other_topic(source) : fuzz::drain(source);
  };
  static_cast<void>(is_rosbag1(bytes));
  try {
    read(false);
    read(true);
  } catch (const FormatError&) {  // of an older version
  }
  return 0;
}
