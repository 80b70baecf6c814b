// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <Eigen/Core>
#include <unordered_map>
#include <vector>

namespace setsquare {

/// Things by their position, in square cells: finds those around a place without looking at the
/// others.
class PositionHash {
 public:
  explicit PositionHash(double cell_m) : cell_m_(cell_m) {}

  void add(const Eigen::Vector2d& position_m, std::size_t index) {
    cells_[key(cell_of(position_m.x()), cell_of(position_m.y()))].push_back(index);
  }

  /// Calls visit(index) for all in the cells that the square of this half side touches, cell by
  /// cell in a fixed order.
  template <typename Visit>
  void visit(const Eigen::Vector2d& centre_m, double half_side_m, Visit visit) const {
    const std::int32_t last_column = cell_of(centre_m.x() + half_side_m);
    const std::int32_t last_row = cell_of(centre_m.y() + half_side_m);
    for (std::int32_t row = cell_of(centre_m.y() - half_side_m); row <= last_row; ++row) {
      for (std::int32_t c = cell_of(centre_m.x() - half_side_m); c <= last_column; ++c) {
        const auto cell = cells_.find(key(c, row));
        if (cell == cells_.end()) continue;
        for (const std::size_t index : cell->second) visit(index);
      }
    }
  }

 private:
  [[nodiscard]] std::int32_t cell_of(double coordinate_m) const {
    return static_cast<std::int32_t>(std::floor(coordinate_m / cell_m_));
  }
  [[nodiscard]] static std::uint64_t key(std::int32_t column, std::int32_t row) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32 |
           static_cast<std::uint32_t>(row);
  }

  double cell_m_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

}  // namespace setsquare
