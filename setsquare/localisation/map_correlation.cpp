// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/map_correlation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "setsquare/core/wider_clones.hpp"

namespace setsquare {
namespace {

// What a sample adds when it falls on a cell, above kUnknownValue: bytes stay unsigned.
constexpr std::uint8_t kFreeValue = 0;
constexpr std::uint8_t kUnknownValue = 1;
constexpr std::uint8_t kNearWallValue = 2;
constexpr std::uint8_t kWallValue = 3;

using TileBytes [[gnu::vector_size(MapCorrelation::kTileWidth / 2)]] = std::uint8_t;

/// The sums of the samples' cells for a tile's translations. Whether one reaches the floor.
SETSQUARE_WIDER_CLONES bool sum_tile(const std::uint8_t* first,
                                     const std::ptrdiff_t* offsets,
                                     std::size_t num_samples,
                                     std::uint8_t floor,
                                     std::uint8_t* sums) {
  TileBytes left{};
  TileBytes right{};
  for (std::size_t k = 0; k < num_samples; ++k) {
    const std::uint8_t* row = first + offsets[k];
    TileBytes cells;
    std::memcpy(&cells, row, sizeof cells);
    left += cells;
    std::memcpy(&cells, row + sizeof cells, sizeof cells);
    right += cells;
  }
  std::memcpy(sums, &left, sizeof left);
  std::memcpy(sums + sizeof left, &right, sizeof right);
  const auto is_high = (left >= floor) | (right >= floor);
  std::array<std::uint64_t, sizeof is_high / sizeof(std::uint64_t)> words;
  std::memcpy(words.data(), &is_high, sizeof is_high);
  return std::ranges::any_of(words, [](std::uint64_t word) { return word != 0; });
}

}  // namespace

MapCorrelation::MapCorrelation(const WallDistance& walls) {
  const auto side =
      static_cast<std::int32_t>(std::max(1.0, std::round(kCell_m / walls.resolution_m())));
  cell_m_ = side * walls.resolution_m();
  num_columns_ = (walls.num_columns() + side - 1) / side;
  num_rows_ = (walls.num_rows() + side - 1) / side;
  margin_ = static_cast<std::int32_t>(std::ceil(kMaxReach_m / cell_m_)) + 1;
  constexpr auto kWidth = static_cast<std::int32_t>(kTileWidth);
  const std::int32_t tiled_columns = (num_columns_ + kWidth - 1) / kWidth * kWidth;
  stride_ = tiled_columns + 2 * margin_;
  const auto num_cells =
      static_cast<std::size_t>(stride_) * static_cast<std::size_t>(num_rows_ + 2 * margin_);
  cells_.assign(num_cells, kUnknownValue);
  is_free_.assign(num_cells, 0);

  // A cell is a wall where one of the grid's cells in it is, free where more are free than unknown.
  for (std::int32_t row = 0; row < num_rows_; ++row) {
    for (std::int32_t column = 0; column < num_columns_; ++column) {
      int num_free = 0;
      int num_unknown = 0;
      bool is_wall = false;
      for (std::int32_t y = row * side; y < std::min((row + 1) * side, walls.num_rows()); ++y) {
        for (std::int32_t x = column * side; x < std::min((column + 1) * side, walls.num_columns());
             ++x) {
          const CellState state = walls.state({x, y});
          num_free += state == CellState::kFree;
          num_unknown += state == CellState::kUnknown;
          is_wall |= state == CellState::kOccupied;
        }
      }
      const std::size_t cell = cell_index(column, row);
      is_free_[cell] = num_free > 0;
      if (is_wall) {
        cells_[cell] = kWallValue;
      } else if (num_free > num_unknown) {
        cells_[cell] = kFreeValue;
      }
    }
  }
  for (std::int32_t row = 0; row < num_rows_; ++row) {
    for (std::int32_t column = 0; column < num_columns_; ++column) {
      const std::size_t cell = cell_index(column, row);
      if (cells_[cell] != kWallValue) continue;
      const auto stride = static_cast<std::size_t>(stride_);
      for (const std::size_t neighbour : {cell - 1, cell + 1, cell - stride, cell + stride}) {
        cells_[neighbour] = std::max(cells_[neighbour], kNearWallValue);
      }
    }
  }
  widen_free_space();
  for (std::int32_t row = 0; row < num_rows_; ++row) {
    for (std::int32_t column = 0; column < tiled_columns; column += kWidth) {
      const std::uint8_t* first = &is_free_[cell_index(column, row)];
      if (std::any_of(first, first + kTileWidth, [](std::uint8_t is) { return is != 0; })) {
        tiles_.push_back({column, row});
      }
    }
  }
}

void MapCorrelation::widen_free_space() {
  const auto stride = static_cast<std::size_t>(stride_);
  const auto num_steps = static_cast<int>(std::lround(kBeyondFree_m / cell_m_));
  for (int step = 0; step < num_steps; ++step) {
    std::vector<std::uint8_t> wider = is_free_;
    for (std::int32_t row = 0; row < num_rows_; ++row) {
      for (std::int32_t column = 0; column < num_columns_; ++column) {
        const std::size_t cell = cell_index(column, row);
        if (cells_[cell] == kWallValue) continue;
        for (const std::size_t next : {cell - 1, cell + 1, cell - stride, cell + stride}) {
          if (is_free_[next] != 0) wider[cell] = 1;
        }
      }
    }
    is_free_ = std::move(wider);
  }
}

void MapCorrelation::propose(const SurfaceSamples& samples,
                             double rotation_rad,
                             int min_correlation,
                             Scratch& scratch,
                             std::vector<MapProposal>& proposals) const {
  if (samples.size() > kMaxSamples) {
    throw std::invalid_argument("MapCorrelation: more samples than kMaxSamples");
  }
  // The sensor stands in the middle of a cell.
  const double c = std::cos(rotation_rad) / cell_m_;
  const double s = std::sin(rotation_rad) / cell_m_;
  std::array<std::ptrdiff_t, kMaxSamples> offsets;
  std::size_t count = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double x = samples.x_m[i];
    const double y = samples.y_m[i];
    const auto column = static_cast<std::int32_t>(std::floor(c * x - s * y + 0.5));
    const auto row = static_cast<std::int32_t>(std::floor(s * x + c * y + 0.5));
    if (std::max(std::abs(column), std::abs(row)) > margin_) continue;
    offsets[count++] = static_cast<std::ptrdiff_t>(row) * stride_ + column;
  }
  const int unknown = static_cast<int>(count) * kUnknownValue;
  const int floor = std::max(1, min_correlation) + unknown;
  if (floor > 255) return;

  scratch.sums.assign(cells_.size(), 0);
  std::vector<std::uint8_t>& sums = scratch.sums;
  std::vector<Tile> high;
  for (const Tile& tile : tiles_) {
    const std::size_t first = cell_index(tile.column, tile.row);
    if (sum_tile(&cells_[first],
                 offsets.data(),
                 count,
                 static_cast<std::uint8_t>(floor),
                 &sums[first])) {
      high.push_back(tile);
    }
  }
  const auto stride = static_cast<std::size_t>(stride_);
  for (const Tile& tile : high) {
    const std::size_t first = cell_index(tile.column, tile.row);
    for (std::size_t i = first; i < first + kTileWidth; ++i) {
      const int value = sums[i];
      if (value < floor || is_free_[i] == 0) continue;
      const int before =
          std::max({sums[i - stride - 1], sums[i - stride], sums[i - stride + 1], sums[i - 1]});
      const int after =
          std::max({sums[i + stride + 1], sums[i + stride], sums[i + stride - 1], sums[i + 1]});
      if (value <= before || value < after) continue;
      const auto column = tile.column + static_cast<std::int32_t>(i - first);
      proposals.push_back(
          {{(column + 0.5) * cell_m_, (tile.row + 0.5) * cell_m_, rotation_rad}, value - unknown});
    }
  }
}

}  // namespace setsquare
