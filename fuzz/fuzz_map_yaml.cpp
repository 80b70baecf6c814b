// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz/fuzz_target.hpp"
#include "setsquare/io/maps/map_yaml.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace setsquare;
  try {
    const MapYaml map = map_yaml_from_text(fuzz::bytes_from(data, size), "fuzz");
    fuzz::require(!map.image.empty());
    fuzz::require(map.resolution_m > 0.0);
    fuzz::require(map.free_threshold < map.occupied_threshold);
  } catch (const FormatError&) {
  }
  return 0;
}
