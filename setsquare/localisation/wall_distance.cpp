// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/wall_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace setsquare {
namespace {

/// The squared distance of each place of a row to the nearest parabola (Felzenszwalb and
/// Huttenlocher 2012): the parabola of place q stands at q and is `square[q]` high.
class LowerEnvelope {
 public:
  explicit LowerEnvelope(std::size_t length) : vertex_(length), from_(length + 1), found_(length) {}

  void transform(std::vector<float>& square) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const auto length = static_cast<std::int32_t>(square.size());
    std::int32_t k = -1;
    for (std::int32_t q = 0; q < length; ++q) {
      if (square[q] == kInfinity) continue;
      float from = -kInfinity;
      while (k >= 0) {
        const std::int32_t v = vertex_[k];
        from = ((square[q] + static_cast<float>(q) * static_cast<float>(q)) -
                (square[v] + static_cast<float>(v) * static_cast<float>(v))) /
               static_cast<float>(2 * (q - v));
        if (from > from_[k]) break;
        --k;
      }
      ++k;
      vertex_[k] = q;
      from_[k] = k == 0 ? -kInfinity : from;
    }
    if (k < 0) return;
    const std::int32_t last = k;
    k = 0;
    for (std::int32_t q = 0; q < length; ++q) {
      while (k < last && from_[k + 1] < static_cast<float>(q)) ++k;
      const auto apart = static_cast<float>(q - vertex_[k]);
      found_[q] = apart * apart + square[vertex_[k]];
    }
    square.swap(found_);
  }

 private:
  std::vector<std::int32_t> vertex_;
  std::vector<float> from_;
  std::vector<float> found_;
};

}  // namespace

WallDistance::WallDistance(const OccupancyGrid& grid)
    : resolution_m_(grid.resolution_m()),
      num_columns_(grid.num_columns()),
      num_rows_(grid.num_rows()),
      states_(grid.values().size()),
      distance_(grid.values().size()) {
  for (std::int32_t row = 0; row < num_rows_; ++row) {
    for (std::int32_t column = 0; column < num_columns_; ++column) {
      states_[index({column, row})] = grid.state({column, row});
    }
  }
  // Down and up each column: cells to the nearest wall in it. Then along the rows.
  const auto width = static_cast<std::size_t>(num_columns_);
  const auto height = static_cast<std::size_t>(num_rows_);
  const auto reach_cells =
      static_cast<std::uint16_t>(std::min(1e4, std::ceil(kReach_m / resolution_m_) + 1.0));
  std::vector<std::uint16_t> in_column(width * height, reach_cells);
  const auto relax = [&](std::size_t row, std::size_t other_row) {
    for (std::size_t column = 0; column < width; ++column) {
      const std::size_t i = row * width + column;
      const std::uint16_t beyond = in_column[other_row * width + column];
      if (beyond < reach_cells) {
        in_column[i] =
            std::min<std::uint16_t>(in_column[i], static_cast<std::uint16_t>(beyond + 1));
      }
    }
  };
  for (std::size_t i = 0; i < states_.size(); ++i) {
    if (states_[i] == CellState::kOccupied) in_column[i] = 0;
  }
  for (std::size_t row = 1; row < height; ++row) relax(row, row - 1);
  for (std::size_t row = height - 1; row-- > 0;) relax(row, row + 1);

  LowerEnvelope envelope(width);
  std::vector<float> square(width);
  constexpr double kMost = kReach_m / kUnit_m;
  static_assert(kMost <= 255.0);
  for (std::size_t row = 0; row < height; ++row) {
    for (std::size_t column = 0; column < width; ++column) {
      const std::uint16_t cells = in_column[row * width + column];
      square[column] = cells < reach_cells ? static_cast<float>(cells) * static_cast<float>(cells)
                                           : std::numeric_limits<float>::infinity();
    }
    envelope.transform(square);
    for (std::size_t column = 0; column < width; ++column) {
      const double units = std::sqrt(static_cast<double>(square[column])) * resolution_m_ / kUnit_m;
      distance_[row * width + column] =
          static_cast<std::uint8_t>(std::lround(std::min(units, kMost)));
    }
  }
}

CellIndex WallDistance::cell_at(double x_m, double y_m) const {
  const auto cell_of = [&](double coordinate_m) {
    return static_cast<std::int32_t>(
        std::floor(std::clamp(coordinate_m / resolution_m_, -1e9, 1e9)));
  };
  return {cell_of(x_m), cell_of(y_m)};
}

WallDistance::Slope WallDistance::slope_at(float x_m, float y_m) const {
  const auto inverse = static_cast<float>(1.0 / resolution_m_);
  const float u = x_m * inverse - 0.5F;
  const float v = y_m * inverse - 0.5F;
  if (!(u >= 0.0F) || !(v >= 0.0F) || u >= static_cast<float>(num_columns_ - 1) ||
      v >= static_cast<float>(num_rows_ - 1)) {
    return {};
  }
  const auto column = static_cast<std::int32_t>(u);
  const auto row = static_cast<std::int32_t>(v);
  const float a = u - static_cast<float>(column);
  const float b = v - static_cast<float>(row);
  const std::uint8_t* low = &distance_[index({column, row})];
  const std::uint8_t* high = low + num_columns_;
  const float d00 = low[0];
  const float d10 = low[1];
  const float d01 = high[0];
  const float d11 = high[1];
  const float on_low = d00 + a * (d10 - d00);
  const float on_high = d01 + a * (d11 - d01);
  return {.distance_m = kUnit_m * (on_low + b * (on_high - on_low)),
          .along_x = kUnit_m * inverse * ((1.0F - b) * (d10 - d00) + b * (d11 - d01)),
          .along_y = kUnit_m * inverse * (on_high - on_low)};
}

}  // namespace setsquare
