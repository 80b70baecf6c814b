// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/drawing/paint.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "setsquare/drawing/stroke_font.hpp"

namespace setsquare {
namespace {

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

Coverage::Coverage(const Image& image, const Eigen::Vector2d& low, const Eigen::Vector2d& high)
    : columns_(pixels_between(low.x(), high.x(), {0, image.width_px()})),
      rows_(pixels_between(low.y(), high.y(), {0, image.height_px()})),
      shares_(static_cast<std::size_t>(columns_.end - columns_.begin) *
                  static_cast<std::size_t>(rows_.end - rows_.begin),
              0.0F) {}

void Coverage::add_segment(const Eigen::Vector2d& a,
                           const Eigen::Vector2d& b,
                           double half_width_px) {
  const double reach_px = half_width_px + 0.5;
  const Eigen::Vector2d along = b - a;
  const double squared_length = along.squaredNorm();
  const Eigen::Array2d low = a.array().min(b.array()) - reach_px;
  const Eigen::Array2d high = a.array().max(b.array()) + reach_px;
  const Interval rows = pixels_between(low.y(), high.y(), rows_);
  const Interval columns = pixels_between(low.x(), high.x(), columns_);
  for (int row = rows.begin; row < rows.end; ++row) {
    for (int column = columns.begin; column < columns.end; ++column) {
      const Eigen::Vector2d from_a = Eigen::Vector2d(column + 0.5, row + 0.5) - a;
      const double position = squared_length > 0.0 ? from_a.dot(along) / squared_length : 0.0;
      const double distance_px = (from_a - std::clamp(position, 0.0, 1.0) * along).norm();
      const auto covered = static_cast<float>(std::clamp(reach_px - distance_px, 0.0, 1.0));
      share(column, row) = std::max(share(column, row), covered);
    }
  }
}

void Coverage::blend_into(Image& image, Color value) const {
  std::size_t i = 0;
  for (int row = rows_.begin; row < rows_.end; ++row) {
    for (int column = columns_.begin; column < columns_.end; ++column, ++i) {
      if (shares_[i] > 0.0F) image.blend(column, row, value, shares_[i]);
    }
  }
}

Coverage::Interval Coverage::pixels_between(double low, double high, Interval bounds) {
  const double first = std::clamp<double>(low, bounds.begin, bounds.end);
  const double last = std::clamp<double>(high, first, bounds.end);
  return {static_cast<int>(std::floor(first)), static_cast<int>(std::ceil(last))};
}

float& Coverage::share(int column, int row) {
  const auto row_length = static_cast<std::size_t>(columns_.end - columns_.begin);
  return shares_[static_cast<std::size_t>(row - rows_.begin) * row_length +
                 static_cast<std::size_t>(column - columns_.begin)];
}

/// The box of all finite points, widened by the reach; inverted without finite points.
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
