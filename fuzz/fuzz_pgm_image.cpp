// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "fuzz/fuzz_target.hpp"
#include "setsquare/io/maps/pgm_image.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace setsquare;
  try {
    const PgmImage image = read_pgm(make_memory_source(fuzz::bytes_from(data, size)), "fuzz");
    const auto num_pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    fuzz::require(image.values.size() == num_pixels);
    fuzz::require(num_pixels < size);
    fuzz::require(*std::max_element(image.values.begin(), image.values.end()) <= image.white);
  } catch (const FormatError&) {
  }
  return 0;
}
