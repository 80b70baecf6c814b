// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/paper/thinning.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <vector>

namespace setsquare {
namespace {

/// Kept points by square cells of twice the spacing, so that whatever is too near to a point lies
/// in the 2 x 2 cells that meet nearest to it. Cells are hashed into buckets that chain their
/// points; cells that share a bucket only add points to compare, so no key is stored.
class KeptPoints {
 public:
  KeptPoints(std::size_t max_points, double spacing_m)
      : inverse_spacing_(1.0 / spacing_m),
        squared_spacing_m2_(spacing_m * spacing_m),
        first_in_bucket_(std::bit_ceil(2 * max_points + 2), -1) {
    kept_.reserve(max_points);
    next_.reserve(max_points);
  }

  /// Keeps the point unless a kept one is too near.
  void offer(double x_m, double y_m, std::int32_t beam) {
    if (!kept_.empty() && is_near(kept_.size() - 1, x_m, y_m)) return;  // Mostly the last kept one.
    const std::int64_t column = half_cell(x_m);
    const std::int64_t row = half_cell(y_m);
    const std::int64_t next_column = column + 2 * (column & 1) - 1;
    const std::int64_t next_row = row + 2 * (row & 1) - 1;
    const std::size_t own = bucket(column, row);
    if (has_near(own, x_m, y_m) || has_near(bucket(next_column, row), x_m, y_m) ||
        has_near(bucket(column, next_row), x_m, y_m) ||
        has_near(bucket(next_column, next_row), x_m, y_m)) {
      return;
    }
    next_.push_back(first_in_bucket_[own]);
    first_in_bucket_[own] = static_cast<std::int32_t>(kept_.size());
    kept_.push_back(x_m, y_m, beam);
  }

  PointSet take() { return std::move(kept_); }

 private:
  std::int64_t half_cell(double coordinate_m) const {
    constexpr double kLast = 1e15;  // Keeps the cast defined; beyond it cells only grow.
    return static_cast<std::int64_t>(
        std::floor(std::clamp(coordinate_m * inverse_spacing_, -kLast, kLast)));
  }
  std::size_t bucket(std::int64_t half_column, std::int64_t half_row) const {
    const auto column = static_cast<std::uint64_t>(half_column >> 1);
    const auto row = static_cast<std::uint64_t>(half_row >> 1);
    const std::uint64_t mixed = column * 0x9E3779B97F4A7C15ULL + row * 0xC2B2AE3D27D4EB4FULL;
    return static_cast<std::size_t>(mixed >> 32) & (first_in_bucket_.size() - 1);
  }
  bool is_near(std::size_t kept, double x_m, double y_m) const {
    const double dx_m = kept_.x_m[kept] - x_m;
    const double dy_m = kept_.y_m[kept] - y_m;
    return dx_m * dx_m + dy_m * dy_m < squared_spacing_m2_;
  }
  bool has_near(std::size_t in_bucket, double x_m, double y_m) const {
    for (std::int32_t k = first_in_bucket_[in_bucket]; k >= 0; k = next_[k]) {
      if (is_near(static_cast<std::size_t>(k), x_m, y_m)) return true;
    }
    return false;
  }

  double inverse_spacing_;
  double squared_spacing_m2_;
  std::vector<std::int32_t> first_in_bucket_;
  std::vector<std::int32_t> next_;
  PointSet kept_;
};

}  // namespace

PointSet thin(const PointSet& points, double min_spacing_m) {
  assert(min_spacing_m > 0.0);
  KeptPoints kept(points.size(), min_spacing_m);
  for (std::size_t i = 0; i < points.size(); ++i) {
    kept.offer(points.x_m[i], points.y_m[i], points.beam[i]);
  }
  return kept.take();
}

}  // namespace setsquare
