// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstring>

#include "setsquare/surfaces/lanes.hpp"
#include "setsquare/surfaces/surface_image.hpp"

namespace setsquare {

/// Four sectors of a surface image side by side, an array a field.
struct SectorLanes {
  Floats normal_x, normal_y, offset_m, free_square_m2;
};

/// Offsets beyond it are no surface's.
inline constexpr float kHalfNoSurface_m = 0.5F * SurfaceImage::kNoSurface_m;

/// The sectors of four indices: four loads and a transposition.
[[nodiscard]] inline SectorLanes gather(const SurfaceSector* sectors, Ints index) {
  static_assert(sizeof(SurfaceSector) == sizeof(Floats));
  std::array<Floats, kLanes> rows;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    std::memcpy(&rows[lane], &sectors[index[lane]], sizeof(Floats));
  }
  const Floats a = __builtin_shufflevector(rows[0], rows[1], 0, 4, 1, 5);
  const Floats b = __builtin_shufflevector(rows[2], rows[3], 0, 4, 1, 5);
  const Floats c = __builtin_shufflevector(rows[0], rows[1], 2, 6, 3, 7);
  const Floats d = __builtin_shufflevector(rows[2], rows[3], 2, 6, 3, 7);
  return {__builtin_shufflevector(a, b, 0, 1, 4, 5),
          __builtin_shufflevector(a, b, 2, 3, 6, 7),
          __builtin_shufflevector(c, d, 0, 1, 4, 5),
          __builtin_shufflevector(c, d, 2, 3, 6, 7)};
}

}  // namespace setsquare
