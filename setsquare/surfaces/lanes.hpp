// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Four floats side by side, in one register of every machine that we build for. Written with the
// compilers' vector types: no intrinsics, the same bits everywhere.
// benchmarks/stages (alignment) measures the gain in speed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace setsquare {

inline constexpr std::size_t kLanes = 4;
using Floats [[gnu::vector_size(4 * kLanes)]] = float;
using Ints [[gnu::vector_size(4 * kLanes)]] = std::int32_t;

[[nodiscard]] inline Floats spread(float value) { return Floats{value, value, value, value}; }

[[nodiscard]] inline Floats load_lanes(const float* values) {
  Floats lanes;
  std::memcpy(&lanes, values, sizeof lanes);
  return lanes;
}

/// The value where the mask (all ones or all zeros in a lane, as comparisons give it) is set, else
/// 0.
[[nodiscard]] inline Floats where(Ints mask, Floats value) {
  Ints bits;
  std::memcpy(&bits, &value, sizeof bits);
  bits &= mask;
  Floats kept;
  std::memcpy(&kept, &bits, sizeof kept);
  return kept;
}

[[nodiscard]] inline Floats select(Ints mask, Floats if_set, Floats if_clear) {
  return where(mask, if_set) + where(~mask, if_clear);
}

[[nodiscard]] inline Floats absolute(Floats value) {
  const std::int32_t m = 0x7FFFFFFF;
  return where(Ints{m, m, m, m}, value);
}

[[nodiscard]] inline float sum_of(Floats value) {
  return (value[0] + value[2]) + (value[1] + value[3]);
}

}  // namespace setsquare
