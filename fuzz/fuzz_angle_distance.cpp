// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz/fuzz_target.hpp"
#include "setsquare/io/logs/angle_distance/log.hpp"

// Both layouts and both units of angles.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace setsquare;
  using Layout = AngleDistanceOptions::Layout;
  const std::string bytes = fuzz::bytes_from(data, size);
  static_cast<void>(has_angle_distance_rows(bytes));
  for (const Layout layout : {Layout::kPairs, Layout::kRevolutions}) {
    AngleDistanceOptions options;
    options.layout = layout;
    options.is_in_degrees = layout == Layout::kPairs;
    AngleDistanceLog log(std::make_unique<InputBuffer>(make_memory_source(bytes)), options);
    fuzz::drain(log);
  }
  return 0;
}
