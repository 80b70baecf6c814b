// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz/fuzz_target.hpp"
#include "setsquare/io/bytes/byte_source.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace setsquare;
  try {
    const Trajectory trajectory =
        read_trajectory_tum(make_memory_source(fuzz::bytes_from(data, size)), "fuzz");
    // What was read can be written, and reads back with as many poses and the same stamps to the
    // microsecond.
    const Trajectory again =
        read_trajectory_tum(make_memory_source(tum_from_trajectory(trajectory)), "written");
    fuzz::require(again.size() == trajectory.size());
    for (std::size_t i = 0; i < again.size(); ++i) {
      fuzz::require(std::abs(again[i].stamp.ns - trajectory[i].stamp.ns) <= 500);
    }
  } catch (const FormatError&) {
  }
  return 0;
}
