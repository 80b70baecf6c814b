// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/drawing/color.hpp"

namespace setsquare {

/// A raster of pixels, row 0 at the top, column 0 at the left.
class Image {
 public:
  /// Width and height in pixels, both positive.
  Image(int width_px, int height_px, Color background);

  [[nodiscard]] int width_px() const { return width_px_; }
  [[nodiscard]] int height_px() const { return height_px_; }
  [[nodiscard]] bool contains(int column, int row) const {
    return column >= 0 && row >= 0 && column < width_px_ && row < height_px_;
  }
  /// The pixel must lie in the image.
  [[nodiscard]] Color at(int column, int row) const { return pixels_[index(column, row)]; }
  void set(int column, int row, Color value) { pixels_[index(column, row)] = value; }
  /// Covers a share (0 to 1) of the pixel; nothing happens outside the image.
  void blend(int column, int row, Color value, double coverage);
  /// The pixels row by row, three bytes each.
  [[nodiscard]] const std::vector<Color>& pixels() const { return pixels_; }

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_px_) +
           static_cast<std::size_t>(column);
  }

  int width_px_;
  int height_px_;
  std::vector<Color> pixels_;
};

}  // namespace setsquare
