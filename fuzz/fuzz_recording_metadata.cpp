// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz/fuzz_target.hpp"
#include "setsquare/io/bags/recording_metadata.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace setsquare;
  const std::string text = fuzz::bytes_from(data, size);
  try {
    const RecordingMetadata metadata = recording_metadata_from_text(text, "fuzz");
    for (const std::string& file : metadata.files) fuzz::require(!file.empty());
    fuzz::require(metadata.files.size() + metadata.topics.size() <= size);
  } catch (const FormatError&) {
  }
  return 0;
}
