// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/drawing/image.hpp"

#include <cassert>

namespace setsquare {

Image::Image(int width_px, int height_px, Color background)
    : width_px_(width_px),
      height_px_(height_px),
      pixels_(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px),
              background) {
  assert(width_px > 0 && height_px > 0);
}

void Image::blend(int column, int row, Color value, double coverage) {
  if (!contains(column, row)) return;
  Color& pixel = pixels_[index(column, row)];
  pixel = mix(pixel, value, coverage);
}

}  // namespace setsquare
