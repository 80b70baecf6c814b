// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/drawing/paint.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "setsquare/drawing/coverage.hpp"
#include "setsquare/drawing/stroke_font.hpp"

namespace setsquare {
namespace {

/// The box of all finite points, widened by the reach; inverted where there is none.
Coverage coverage_around(const Image& image,
                         std::span<const Stroke> strokes,
                         double half_width_px) {
  Eigen::Array2d low(image.width_px(), image.height_px());
  Eigen::Array2d high(0.0, 0.0);
  for (const Stroke& stroke : strokes) {
    for (const PixelPoint& point : stroke) {
      if (!point.allFinite()) continue;
      low = low.min(point.array());
      high = high.max(point.array());
    }
  }
  const double reach_px = half_width_px + 0.5;
  return {image, low.matrix().array() - reach_px, high.matrix().array() + reach_px};
}

void draw_strokes(Image& image, std::span<const Stroke> strokes, double width_px, Color value) {
  const double half_width_px = 0.5 * width_px;
  Coverage coverage = coverage_around(image, strokes, half_width_px);
  for (const Stroke& stroke : strokes) {
    for (std::size_t i = 0; i < stroke.size(); ++i) {
      const PixelPoint& from = stroke[i > 0 ? i - 1 : 0];
      if (!stroke[i].allFinite() || !from.allFinite()) continue;
      if (i > 0 || stroke.size() == 1) coverage.add_segment(from, stroke[i], half_width_px);
    }
  }
  coverage.blend_into(image, value);
}

}  // namespace

void draw_polyline(Image& image, std::span<const PixelPoint> points, double width_px, Color value) {
  const Stroke stroke(points.begin(), points.end());
  draw_strokes(image, {&stroke, 1}, width_px, value);
}

void fill_disc(Image& image, const PixelPoint& centre, double radius_px, Color value) {
  const Stroke dot = {centre};
  draw_strokes(image, {&dot, 1}, 2.0 * radius_px, value);
}

void fill_rectangle(Image& image, const PixelPoint& corner, const PixelPoint& other, Color value) {
  const Eigen::Array2d size(image.width_px(), image.height_px());
  const Eigen::Array2d low = (corner.array().min(other.array()) + 0.5).max(0.0).min(size);
  const Eigen::Array2d high = (corner.array().max(other.array()) + 0.5).max(0.0).min(size);
  for (int row = static_cast<int>(low.y()); row < static_cast<int>(high.y()); ++row) {
    for (int column = static_cast<int>(low.x()); column < static_cast<int>(high.x()); ++column) {
      image.set(column, row, value);
    }
  }
}

void draw_text(Image& image,
               const PixelPoint& position,
               std::string_view text,
               double cap_height_px,
               Color value,
               TextAnchor anchor) {
  const double width_px = text_width(text) * cap_height_px;
  const double share = anchor == TextAnchor::kStart    ? 0.0
                       : anchor == TextAnchor::kMiddle ? 0.5
                                                       : 1.0;
  const PixelPoint start(position.x() - share * width_px, position.y());
  std::vector<Stroke> strokes = strokes_of_text(text);
  for (Stroke& stroke : strokes) {
    for (PixelPoint& point : stroke) {
      point = start + cap_height_px * PixelPoint(point.x(), -point.y());
    }
  }
  draw_strokes(image, strokes, std::max(1.0, 0.14 * cap_height_px), value);
}

}  // namespace setsquare
