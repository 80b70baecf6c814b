// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/surfaces/correlation_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "setsquare/core/wider_clones.hpp"

namespace setsquare {
namespace {

// What a sample adds when it falls on a cell, above kUnknownValue: bytes stay unsigned, for which
// every machine has a maximum.
constexpr std::uint8_t kFreeValue = 0;
constexpr std::uint8_t kUnknownValue = 1;
constexpr std::uint8_t kNearSurfaceValue = 2;
constexpr std::uint8_t kSurfaceValue = 3;
constexpr float kCellsPerMetre = static_cast<float>(1.0 / CorrelationGrid::kCell_m);

int cell_of(float coordinate_m) {
  return static_cast<int>(std::floor(coordinate_m * kCellsPerMetre));
}

constexpr int kWindow = CorrelationGrid::kWindow;
using WindowSums = std::array<std::array<std::uint8_t, kWindow>, kWindow>;

/// Half a row of the window, in one register where the machine has such.
using Bytes [[gnu::vector_size(kWindow / 2)]] = std::uint8_t;

/// The sum of the samples' cells under every translation of the window, and which rows hold one
/// that reaches the floor.
SETSQUARE_WIDER_CLONES void sum_window(const std::uint8_t* const* first_cells,
                                       std::size_t num_samples,
                                       std::uint8_t floor,
                                       WindowSums& sums,
                                       std::array<bool, kWindow>& reaches_floor) {
  for (int y = 0; y < kWindow; ++y) {
    Bytes left{};
    Bytes right{};
    for (std::size_t k = 0; k < num_samples; ++k) {
      const std::uint8_t* row = first_cells[k] + y * CorrelationGrid::kSide;
      Bytes cells;
      std::memcpy(&cells, row, sizeof cells);
      left += cells;
      std::memcpy(&cells, row + sizeof cells, sizeof cells);
      right += cells;
    }
    std::memcpy(sums[y].data(), &left, sizeof left);
    std::memcpy(sums[y].data() + sizeof left, &right, sizeof right);
    const auto is_high = (left >= floor) | (right >= floor);
    std::array<std::uint64_t, sizeof is_high / sizeof(std::uint64_t)> words;
    std::memcpy(words.data(), &is_high, sizeof is_high);
    reaches_floor[y] = (words[0] | words[1] | words[2] | words[3]) != 0;
  }
}

}  // namespace

CorrelationGrid::CorrelationGrid(const SurfacePoints& points, const SurfaceImage& image)
    : cells_(static_cast<std::size_t>(kSide) * kSide, kUnknownValue) {
  draw_free_space(image);
  draw_surfaces(points);
}

void CorrelationGrid::draw_free_space(const SurfaceImage& image) {
  // Rays no denser than a cell's width at the grid's border.
  constexpr int kNumRays = 512;
  const int num_sectors = static_cast<int>(image.num_sectors());
  const int stride = std::max(1, num_sectors / kNumRays);
  for (int k = stride / 2; k < num_sectors; k += stride) {
    const float free_m = std::min(std::sqrt(image.sector(k).free_square_m2),
                                  static_cast<float>(kHalfExtentCells * kCell_m));
    // The middle of the sector, from its diamond angle.
    const float angle =
        (static_cast<float>(k) + 0.5F) * 4.0F / static_cast<float>(num_sectors) - 1.0F;
    const float x = angle <= 1.0F ? 1.0F - std::abs(angle) : std::abs(2.0F - angle) - 1.0F;
    const float y = angle <= 1.0F ? angle : 2.0F - angle;
    const float unit = 1.0F / std::sqrt(x * x + y * y);
    const float end = free_m * kCellsPerMetre;
    for (float t = 0.0F; t < end; t += 1.0F) {
      const int column = static_cast<int>(kCentre + t * unit * x);
      const int row = static_cast<int>(kCentre + t * unit * y);
      cells_[row * kSide + column] = kFreeValue;
    }
  }
}

void CorrelationGrid::draw_surfaces(const SurfacePoints& points) {
  std::vector<int> surface_cells;
  surface_cells.reserve(4 * points.size());
  const auto mark = [&](float x_m, float y_m) {
    const int column = cell_of(x_m);
    const int row = cell_of(y_m);
    if (std::max(std::abs(column), std::abs(row)) >= kHalfExtentCells) return;
    const int cell = (row + kCentre) * kSide + column + kCentre;
    if (surface_cells.empty() || surface_cells.back() != cell) surface_cells.push_back(cell);
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    mark(points.x_m[i], points.y_m[i]);
    if (!points.joined[i]) continue;
    const float dx_m = points.x_m[i + 1] - points.x_m[i];
    const float dy_m = points.y_m[i + 1] - points.y_m[i];
    const int num_between =
        static_cast<int>(std::max(std::abs(dx_m), std::abs(dy_m)) * kCellsPerMetre);
    for (int k = 1; k <= num_between; ++k) {
      const float share = static_cast<float>(k) / static_cast<float>(num_between + 1);
      mark(points.x_m[i] + share * dx_m, points.y_m[i] + share * dy_m);
    }
  }
  for (const int cell : surface_cells) {
    for (const int neighbour : {cell - 1, cell + 1, cell - kSide, cell + kSide}) {
      cells_[neighbour] = std::max(cells_[neighbour], kNearSurfaceValue);
    }
  }
  for (const int cell : surface_cells) cells_[cell] = kSurfaceValue;
}

CorrelationGrid::Rows CorrelationGrid::rows_of(const SurfaceSamples& current,
                                               const Pose2& middle) const {
  const float c = static_cast<float>(std::cos(middle.theta_rad));
  const float s = static_cast<float>(std::sin(middle.theta_rad));
  const float x_m = static_cast<float>(middle.x_m);
  const float y_m = static_cast<float>(middle.y_m);
  Rows rows;
  for (std::size_t i = 0; i < current.size(); ++i) {
    const int column = cell_of(c * current.x_m[i] - s * current.y_m[i] + x_m);
    const int row = cell_of(s * current.x_m[i] + c * current.y_m[i] + y_m);
    if (std::max(std::abs(column), std::abs(row)) >= kHalfExtentCells + kMargin) continue;
    rows.first[rows.count++] =
        &cells_[(row + kCentre - kMargin) * kSide + column + kCentre - kMargin];
  }
  return rows;
}

void CorrelationGrid::propose_translations(const SurfaceSamples& current,
                                           const Pose2& middle,
                                           int min_correlation,
                                           std::vector<TranslationProposal>& proposals) const {
  if (current.size() > kMaxSamples) {
    throw std::invalid_argument("CorrelationGrid: more samples than kMaxSamples");
  }
  const Rows rows = rows_of(current, middle);
  const int floor = std::max(1, min_correlation) + static_cast<int>(rows.count) * kUnknownValue;
  if (floor > 255) return;

  WindowSums sums;
  std::array<bool, kWindow> reaches_floor;
  sum_window(rows.first.data(), rows.count, static_cast<std::uint8_t>(floor), sums, reaches_floor);
  for (int y = 1; y + 1 < kWindow; ++y) {
    if (!reaches_floor[y]) continue;
    for (int x = 1; x + 1 < kWindow; ++x) {
      const int value = sums[y][x];
      if (value < floor) continue;
      const int before =
          std::max({sums[y - 1][x - 1], sums[y - 1][x], sums[y - 1][x + 1], sums[y][x - 1]});
      const int after =
          std::max({sums[y + 1][x - 1], sums[y + 1][x], sums[y + 1][x + 1], sums[y][x + 1]});
      if (value <= before || value < after) continue;
      proposals.push_back({{middle.x_m + (x - kMargin) * kCell_m,
                            middle.y_m + (y - kMargin) * kCell_m,
                            middle.theta_rad},
                           value - static_cast<int>(rows.count) * kUnknownValue});
    }
  }
}

}  // namespace setsquare
