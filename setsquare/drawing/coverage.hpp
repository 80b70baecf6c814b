// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <vector>

#include "setsquare/drawing/image.hpp"

namespace setsquare {

/// How much of each pixel of a box a shape covers, 0 to 1. What is added overlaps by the maximum,
/// so that strokes that cross or join keep their smooth edges.
class Coverage {
 public:
  /// The box from low to high (pixels, y down), cut to the image.
  Coverage(const Image& image, const Eigen::Vector2d& low, const Eigen::Vector2d& high);

  /// A thick line with round ends; a disc where both ends are the same.
  void add_segment(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double half_width_px);

  void blend_into(Image& image, Color value) const;

 private:
  struct Interval {
    int begin = 0;
    int end = 0;
  };

  /// The pixels of [low, high] that lie in the bounds.
  static Interval pixels_between(double low, double high, Interval bounds);
  [[nodiscard]] float& share(int column, int row);

  Interval columns_;
  Interval rows_;
  std::vector<float> shares_;
};

}  // namespace setsquare
