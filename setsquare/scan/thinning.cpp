// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/scan/thinning.hpp"

#include <cassert>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace setsquare {
namespace {

/// Kept points by square cells as wide as the spacing: whatever is too near lies in the 3 x 3 cells
/// around. Each cell chains its points through `next`.
class KeptPoints {
 public:
  KeptPoints(std::size_t max_points, double spacing_m) : inverse_cell_m_(1.0 / spacing_m) {
    first_in_cell_.reserve(max_points);
    next_.reserve(max_points);
  }

  bool has_neighbour(const PointSet& kept, double x_m, double y_m, double spacing_m) const {
    const std::int64_t column = cell(x_m);
    const std::int64_t row = cell(y_m);
    for (std::int64_t r = row - 1; r <= row + 1; ++r) {
      for (std::int64_t c = column - 1; c <= column + 1; ++c) {
        const auto found = first_in_cell_.find(key(c, r));
        if (found == first_in_cell_.end()) continue;
        for (std::int32_t k = found->second; k >= 0; k = next_[k]) {
          const double dx = kept.x_m[k] - x_m;
          const double dy = kept.y_m[k] - y_m;
          if (dx * dx + dy * dy < spacing_m * spacing_m) return true;
        }
      }
    }
    return false;
  }

  void add(double x_m, double y_m) {
    const auto index = static_cast<std::int32_t>(next_.size());
    const auto [entry, is_new] = first_in_cell_.try_emplace(key(cell(x_m), cell(y_m)), index);
    next_.push_back(is_new ? -1 : entry->second);
    entry->second = index;
  }

 private:
  std::int64_t cell(double coordinate_m) const {
    return static_cast<std::int64_t>(std::floor(coordinate_m * inverse_cell_m_));
  }
  static std::int64_t key(std::int64_t column, std::int64_t row) {
    return column * 4'294'967'291 + row;
  }

  double inverse_cell_m_;
  std::unordered_map<std::int64_t, std::int32_t> first_in_cell_;
  std::vector<std::int32_t> next_;
};

}  // namespace

PointSet thin(const PointSet& points, double min_spacing_m) {
  assert(min_spacing_m > 0.0);
  PointSet kept;
  kept.reserve(points.size());
  KeptPoints index(points.size(), min_spacing_m);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (index.has_neighbour(kept, points.x_m[i], points.y_m[i], min_spacing_m)) continue;
    index.add(points.x_m[i], points.y_m[i]);
    kept.push_back(points.x_m[i], points.y_m[i], points.beam[i]);
  }
  return kept;
}

}  // namespace setsquare
