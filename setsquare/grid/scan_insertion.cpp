// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/grid/scan_insertion.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "setsquare/core/error.hpp"

namespace setsquare {

void ScanInsertionParams::validate() const {
  if (!(hit_log_odds > 0.0)) throw ParameterError("hit_log_odds", "must be positive");
  if (!(pass_log_odds < 0.0)) throw ParameterError("pass_log_odds", "must be negative");
  if (no_returns_per_pass < 1) throw ParameterError("no_returns_per_pass", "must be positive");
  if (!(max_log_odds > 0.0)) throw ParameterError("max_log_odds", "must be positive");
  if (!(min_log_odds < 0.0)) throw ParameterError("min_log_odds", "must be negative");
}

EvidenceBand::EvidenceBand(std::int32_t first_row,
                           std::int32_t num_columns,
                           std::span<float> num_passes,
                           std::span<std::uint16_t> num_hits)
    : first_row_(first_row),
      end_row_(first_row + static_cast<std::int32_t>(num_hits.size()) / num_columns),
      num_columns_(num_columns),
      num_passes_(num_passes),
      num_hits_(num_hits) {
  assert(num_passes.size() == num_hits.size());
}

void EvidenceBand::keep(CellIndex cell) {
  if (!contains(cell)) return;
  const std::size_t i = index(cell);
  kept_.push_back({i, num_passes_[i]});
}

void EvidenceBand::hit(CellIndex cell) {
  if (!contains(cell)) return;
  std::uint16_t& num_hits = num_hits_[index(cell)];
  if (num_hits < std::numeric_limits<std::uint16_t>::max()) ++num_hits;
  keep(cell);
}

void EvidenceBand::keep_joint(SubcellPoint from, SubcellPoint to) {
  RayTraversal ray(from, to);
  for (std::int32_t step = 1; step < ray.num_steps(); ++step) {
    ray.advance();
    keep(ray.cell());
  }
}

void EvidenceBand::pass(SubcellPoint from, SubcellPoint to, float weight) {
  RayTraversal ray(from, to);
  const std::int32_t from_row = ray.cell().row;
  const std::int32_t to_row = cell_of(to).row;
  const auto [lowest, highest] = std::minmax(from_row, to_row);
  if (highest < first_row_ || lowest >= end_row_) return;
  // From the ray's first cell in the band to its last, but not to the ray's last.
  const bool is_rising = to_row >= from_row;
  const std::int32_t row_behind = is_rising ? end_row_ : first_row_ - 1;
  const bool leaves = is_rising ? to_row >= end_row_ : to_row < first_row_;
  const std::int32_t end = leaves ? ray.num_steps_to_row(row_behind) : ray.num_steps();
  const std::int32_t first = std::clamp(from_row, first_row_, end_row_ - 1);
  std::int32_t step = ray.num_steps_to_row(first);
  ray.advance_to_row(first);
  const auto is_column = [this](std::int32_t column) {
    return column >= 0 && column < num_columns_;
  };
  const bool is_inside = is_column(cell_of(from).column) && is_column(cell_of(to).column);
  float* const num_passes = num_passes_.data();
  const auto stride = static_cast<std::ptrdiff_t>(num_columns_);
  RayTraversal walk = ray;  // a copy whose address is not taken stays in registers
  for (; step < end; ++step, walk.advance()) {
    const CellIndex cell = walk.cell();
    if (!is_inside && !is_column(cell.column)) continue;
    num_passes[(cell.row - first_row_) * stride + cell.column] += weight;
  }
}

void EvidenceBand::count(const Pose2& T_grid_sensor,
                         double resolution_m,
                         std::span<const BeamEnd> ends,
                         const ScanInsertionParams& params) {
  const double cells_per_m = 1.0 / resolution_m;
  const double c = std::cos(T_grid_sensor.theta_rad);
  const double s = std::sin(T_grid_sensor.theta_rad);
  const auto subcell_of = [&](double x_m, double y_m) {
    return subcell_at((T_grid_sensor.x_m + c * x_m - s * y_m) * cells_per_m,
                      (T_grid_sensor.y_m + s * x_m + c * y_m) * cells_per_m);
  };
  const SubcellPoint start = subcell_of(0.0, 0.0);
  stops_.clear();
  kept_.clear();
  SubcellPoint last_return;
  for (const BeamEnd& end : ends) {
    const SubcellPoint stop = subcell_of(end.x_m, end.y_m);
    stops_.push_back(stop);
    if (!end.is_return) continue;
    const CellIndex cell = cell_of(stop);
    hit(cell);
    if (end.is_joined) keep_joint(last_return, stop);
    last_return = stop;
  }
  const auto weight = static_cast<float>(params.no_returns_per_pass);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    pass(start, stops_[i], ends[i].is_return ? weight : 1.0F);
  }
  for (const Kept& kept : kept_) num_passes_[kept.index] = kept.num_passes;
}

void EvidenceBand::finish(const ScanInsertionParams& params) {
  const double per_pass = params.pass_log_odds / params.no_returns_per_pass;
  for (std::size_t i = 0; i < num_hits_.size(); ++i) {
    const double sum = params.hit_log_odds * num_hits_[i] + per_pass * num_passes_[i];
    num_passes_[i] = static_cast<float>(std::clamp(sum, params.min_log_odds, params.max_log_odds));
  }
}

}  // namespace setsquare
