// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz/fuzz_target.hpp"
#include "setsquare/io/bags/rosbag1.hpp"

namespace {

using namespace setsquare;

/// With some topics unwanted, whose messages are jumped over, or with none.
void read(const std::string& bytes, bool are_some_unwanted) {
  Rosbag1 source(std::make_unique<InputBuffer>(make_memory_source(bytes)), "fuzz");
  if (!are_some_unwanted) {
    fuzz::drain(source);
    return;
  }
  bool is_wanted = false;
  source.set_wanted([&is_wanted](const MessageTopic&) { return is_wanted = !is_wanted; });
  Message message;
  while (source.read(message)) fuzz::require(message.topic % 2 == 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = fuzz::bytes_from(data, size);
  static_cast<void>(is_rosbag1(bytes));
  try {
    read(bytes, false);
    read(bytes, true);
  } catch (const FormatError&) {  // of an older version
  }
  return 0;
}
