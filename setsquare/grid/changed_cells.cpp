// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/grid/changed_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "setsquare/core/error.hpp"
#include "setsquare/core/sort_by.hpp"

namespace setsquare {

void ChangedCellParams::validate() const {
  if (!(sure_log_odds > 0.0)) throw ParameterError("sure_log_odds", "must be positive");
  if (!(same_wall_m >= 0.0)) throw ParameterError("same_wall_m", "must not be negative");
}

ChangedCells::ChangedCells(std::int32_t num_columns,
                           std::int32_t num_rows,
                           double resolution_m,
                           const ScanInsertionParams& insertion,
                           const ChangedCellParams& params)
    : num_columns_(num_columns),
      num_rows_(num_rows),
      resolution_m_(resolution_m),
      insertion_(insertion),
      params_(params),
      reach_(static_cast<std::int32_t>(std::ceil(params.same_wall_m / resolution_m - 1e-9))),
      is_changed_(static_cast<std::size_t>(num_columns) * static_cast<std::size_t>(num_rows), 0) {
  params.validate();
}

ChangedCells::Sure ChangedCells::sure_of(const CellCounts& counts, std::size_t cell) const {
  const double per_pass = insertion_.pass_log_odds / insertion_.no_returns_per_pass;
  const double sum =
      insertion_.hit_log_odds * counts.num_hits[cell] + per_pass * counts.num_passes[cell];
  if (sum >= params_.sure_log_odds) return Sure::kOccupied;
  return sum <= -params_.sure_log_odds ? Sure::kFree : Sure::kNothing;
}

template <typename Visit>
void ChangedCells::visit_about(std::size_t cell, std::int32_t reach, Visit visit) const {
  const auto column = static_cast<std::int32_t>(cell % static_cast<std::size_t>(num_columns_));
  const auto row = static_cast<std::int32_t>(cell / static_cast<std::size_t>(num_columns_));
  for (std::int32_t r = std::max(0, row - reach); r <= std::min(num_rows_ - 1, row + reach); ++r) {
    const std::size_t first = static_cast<std::size_t>(r) * static_cast<std::size_t>(num_columns_);
    for (std::int32_t c = std::max(0, column - reach);
         c <= std::min(num_columns_ - 1, column + reach);
         ++c) {
      visit(first + static_cast<std::size_t>(c));
    }
  }
}

bool ChangedCells::is_wall_near(const std::vector<Sure>& sure, std::size_t cell) const {
  bool is_near = false;
  visit_about(cell, reach_, [&](std::size_t other) {
    is_near = is_near || sure[other] == Sure::kOccupied;
  });
  return is_near;
}

void ChangedCells::add_older(const CellCounts& newer, const CellCounts& older) {
  const std::size_t num_cells = is_changed_.size();
  std::vector<Sure> by_newer(num_cells);
  std::vector<Sure> by_older(num_cells);
  for (std::size_t i = 0; i < num_cells; ++i) {
    by_newer[i] = sure_of(newer, i);
    by_older[i] = sure_of(older, i);
  }
  const auto is_contradicted = [&](std::size_t i) {
    return is_changed_[i] == 0 && by_newer[i] != by_older[i] && by_newer[i] != Sure::kNothing &&
           by_older[i] != Sure::kNothing;
  };
  std::vector<std::size_t> changed;
  for (std::size_t i = 0; i < num_cells; ++i) {
    if (!is_contradicted(i)) continue;
    if (!is_wall_near(by_newer[i] == Sure::kFree ? by_newer : by_older, i)) changed.push_back(i);
  }
  for (const std::size_t i : changed) is_changed_[i] = 1;
  for (std::size_t next = 0; next < changed.size(); ++next) {
    visit_about(changed[next], 1, [&](std::size_t other) {
      if (!is_contradicted(other)) return;
      is_changed_[other] = 1;
      changed.push_back(other);
    });
  }
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint16_t>::max();
  for (std::size_t i = 0; i < num_cells; ++i) {
    if (is_changed_[i] != 0) continue;
    newer.num_passes[i] += older.num_passes[i];
    newer.num_hits[i] = static_cast<std::uint16_t>(
        std::min(kMost, std::uint32_t{newer.num_hits[i]} + older.num_hits[i]));
  }
}

std::vector<ChangedPlace> ChangedCells::places(const CellCounts& counts,
                                               const Pose2& T_map_grid) const {
  std::vector<std::uint8_t> is_left = is_changed_;
  std::vector<ChangedPlace> places;
  for (std::size_t i = 0; i < is_left.size(); ++i) {
    if (is_left[i] == 0) continue;
    ChangedPlace place{.is_gone = sure_of(counts, i) == Sure::kFree};
    std::vector<std::size_t> cells{i};
    is_left[i] = 0;
    Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
    for (std::size_t next = 0; next < cells.size(); ++next) {
      const auto columns = static_cast<std::size_t>(num_columns_);
      sum_m += resolution_m_ * Eigen::Vector2d(static_cast<double>(cells[next] % columns) + 0.5,
                                               static_cast<double>(cells[next] / columns) + 0.5);
      visit_about(cells[next], 1, [&](std::size_t other) {
        const bool is_gone = sure_of(counts, other) == Sure::kFree;
        if (is_left[other] == 0 || is_gone != place.is_gone) return;
        is_left[other] = 0;
        cells.push_back(other);
      });
    }
    place.num_cells = cells.size();
    place.place_m = T_map_grid * Eigen::Vector2d(sum_m / static_cast<double>(cells.size()));
    if (place.num_cells >= params_.min_cells) places.push_back(place);
  }
  sort_by_greatest(places, &ChangedPlace::num_cells);
  return places;
}

}  // namespace setsquare
