// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz/fuzz_target.hpp"
#include "setsquare/io/tables/closures_tsv.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace setsquare;
  try {
    const std::vector<LoopClosure> closures =
        read_closures_tsv(make_memory_source(fuzz::bytes_from(data, size)), "fuzz");
    // What was read can be written, and reads back the same, stamps to the microsecond.
    const std::vector<LoopClosure> again =
        read_closures_tsv(make_memory_source(tsv_from_closures(closures)), "written");
    fuzz::require(again.size() == closures.size());
    for (std::size_t i = 0; i < again.size(); ++i) {
      fuzz::require(std::abs(again[i].stamp_i.ns - closures[i].stamp_i.ns) <= 500);
      fuzz::require(again[i].T_i_j == closures[i].T_i_j);
      fuzz::require(again[i].weight == closures[i].weight);
      fuzz::require(again[i].axes == closures[i].axes);
      fuzz::require(again[i].is_accepted == closures[i].is_accepted);
    }
  } catch (const FormatError&) {
  }
  return 0;
}
