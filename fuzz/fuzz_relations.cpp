// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz/fuzz_target.hpp"
#include "setsquare/io/bytes/byte_source.hpp"
#include "setsquare/io/tables/relations.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace setsquare;
  const std::string bytes = fuzz::bytes_from(data, size);
  try {
    fuzz::require(!read_relations(make_memory_source(bytes), "fuzz").empty());
  } catch (const FormatError&) {
  }
  try {
    fuzz::require(!read_overlaps(make_memory_source(bytes), "fuzz").empty());
  } catch (const FormatError&) {
  }
  return 0;
}
