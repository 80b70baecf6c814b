// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/drawing/coverage.hpp"

#include <algorithm>
#include <cmath>

namespace setsquare {

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

}  // namespace setsquare
