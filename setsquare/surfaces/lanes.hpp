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

/// Numbers that one operation takes at once.
inline constexpr std::size_t kLanes = 4;
/// Four floats, which operators take lane by lane.
using Floats [[gnu::vector_size(4 * kLanes)]] = float;
/// Four integers of 32 bits; comparisons of Floats give them as masks.
using Ints [[gnu::vector_size(4 * kLanes)]] = std::int32_t;

/// The value in every lane.
[[nodiscard]] inline Floats spread(float value) { return Floats{value, value, value, value}; }

/// Four values in a row, of any alignment.
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

/// Lane by lane `if_set` where the mask is set, else `if_clear`.
[[nodiscard]] inline Floats select(Ints mask, Floats if_set, Floats if_clear) {
  return where(mask, if_set) + where(~mask, if_clear);
}

/// Lane by lane without the sign.
[[nodiscard]] inline Floats absolute(Floats value) {
  const std::int32_t m = 0x7FFFFFFF;
  return where(Ints{m, m, m, m}, value);
}

/// The lanes' sum, always in the same order.
[[nodiscard]] inline float sum_of(Floats value) {
  return (value[0] + value[2]) + (value[1] + value[3]);
}

}  // namespace setsquare
