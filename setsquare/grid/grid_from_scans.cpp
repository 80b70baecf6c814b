// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/grid/grid_from_scans.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Core>
#include <functional>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/core/parallel.hpp"

namespace setsquare {
namespace {

constexpr double kFarthest_m = 1e6;  // a pose beyond it is not in a building

bool is_usable(const Pose2& pose) {
  return std::abs(pose.x_m) < kFarthest_m && std::abs(pose.y_m) < kFarthest_m &&
         std::isfinite(pose.theta_rad);
}

/// The scans that moved since the last one kept, without those at no usable place.
std::vector<PlacedScan> spaced(std::span<const PlacedScan> scans,
                               const GridFromScansParams& params) {
  std::vector<PlacedScan> kept;
  for (const PlacedScan& placed : scans) {
    const Pose2& pose = placed.T_map_sensor;
    if (!is_usable(pose)) continue;
    if (!kept.empty()) {
      const Pose2 motion = kept.back().T_map_sensor.inverse() * pose;
      if (kept.back().recency == placed.recency &&
          motion.translation().norm() < params.min_spacing_m &&
          std::abs(motion.theta_rad) < params.min_turn_rad) {
        continue;
      }
    }
    kept.push_back(placed);
  }
  return kept;
}

struct Extent {
  Eigen::Array2d low = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array2d high = -low;

  void include(const Eigen::Array2d& point) {
    low = low.min(point);
    high = high.max(point);
  }
  void include(const Extent& other) {
    include(other.low);
    include(other.high);
  }
};

/// A scan as the bands see it: T_grid_sensor, and the rows that its beams reach.
struct GridScan {
  const Scan* scan = nullptr;
  Pose2 T_grid_sensor;
  std::size_t recency = 0;
  Extent extent;  // of the sensor and all ends, in the grid frame, in m
};

/// The scans in the frame that has the grid's directions and the map's origin.
std::vector<GridScan> aligned(const std::vector<PlacedScan>& scans,
                              const Pose2& T_aligned_map,
                              const GridFromScansParams& params) {
  BeamEndFinder finder(params.beams);
  std::vector<GridScan> found;
  found.reserve(scans.size());
  for (const PlacedScan& placed : scans) {
    const Pose2 T_aligned_sensor = T_aligned_map * placed.T_map_sensor;
    const double c = std::cos(T_aligned_sensor.theta_rad);
    const double s = std::sin(T_aligned_sensor.theta_rad);
    Extent extent;
    extent.include(Eigen::Array2d(T_aligned_sensor.x_m, T_aligned_sensor.y_m));
    for (const BeamEnd& end : finder.find(*placed.scan)) {
      extent.include(Eigen::Array2d(T_aligned_sensor.x_m + c * end.x_m - s * end.y_m,
                                    T_aligned_sensor.y_m + s * end.x_m + c * end.y_m));
    }
    found.push_back({placed.scan, T_aligned_sensor, placed.recency, extent});
  }
  return found;
}

/// An unknown grid that holds all scans, which are moved into its frame.
OccupancyGrid grid_over(std::vector<GridScan>& scans,
                        const Pose2& T_map_aligned,
                        const GridFromScansParams& params) {
  Extent extent;
  if (scans.empty()) extent.include(Eigen::Array2d(Eigen::Array2d::Zero()));
  for (const GridScan& scan : scans) extent.include(scan.extent);
  constexpr double kPerMetre = 100.0;  // whole centimetres read well in files
  const Eigen::Array2d low = ((extent.low - params.margin_m) * kPerMetre).floor() / kPerMetre;
  const Eigen::Array2d size = extent.high + params.margin_m - low;
  double resolution_m = params.resolution_m;
  const auto num_cells = [&] { return ((size / resolution_m).ceil() + 1.0).prod(); };
  while (num_cells() > params.max_num_cells) resolution_m *= 2.0;
  const Eigen::Array2d cells = (size / resolution_m).ceil() + 1.0;
  for (GridScan& scan : scans) {
    scan.T_grid_sensor.x_m -= low.x();
    scan.T_grid_sensor.y_m -= low.y();
    scan.extent.low -= low;
    scan.extent.high -= low;
  }
  return {T_map_aligned * Pose2{low.x(), low.y(), 0.0},
          resolution_m,
          static_cast<std::int32_t>(cells.x()),
          static_cast<std::int32_t>(cells.y())};
}

/// The bands of rows that a grid is cut into, a few per thread: calls visit(first_row, cells) for
/// each, with the range of its cells.
template <typename Visit>
void visit_bands(const OccupancyGrid& grid, const GridFromScansParams& params, Visit visit) {
  const auto num_threads = static_cast<std::size_t>(params.num_threads);
  const auto num_rows = static_cast<std::size_t>(grid.num_rows());
  const std::size_t num_bands = std::min(num_threads > 1 ? 4 * num_threads : 1, num_rows);
  run_in_parallel(num_bands, num_threads, [&](std::size_t band) {
    const auto row = static_cast<std::int32_t>(band * num_rows / num_bands);
    const auto end_row = static_cast<std::int32_t>((band + 1) * num_rows / num_bands);
    const std::size_t first = grid.index({0, row});
    visit(row, first, grid.index({0, end_row}) - first);
  });
}

/// Counts the beams of the scans of one session.
void count(const OccupancyGrid& grid,
           const std::vector<GridScan>& scans,
           std::size_t recency,
           const GridFromScansParams& params,
           const CellCounts& counts) {
  visit_bands(grid, params, [&](std::int32_t row, std::size_t first, std::size_t num_cells) {
    EvidenceBand band(row,
                      grid.num_columns(),
                      counts.num_passes.subspan(first, num_cells),
                      counts.num_hits.subspan(first, num_cells));
    BeamEndFinder finder(params.beams);
    const double resolution_m = grid.resolution_m();
    const double low_m = (band.first_row() - 1) * resolution_m;  // a row's slack for rounding
    const double high_m = (band.end_row() + 1) * resolution_m;
    for (const GridScan& scan : scans) {
      if (scan.recency != recency) continue;
      if (scan.extent.high.y() < low_m || scan.extent.low.y() > high_m) continue;
      band.count(scan.T_grid_sensor, resolution_m, finder.find(*scan.scan), params.insertion);
    }
  });
}

/// The sessions of the scans, from the newest to the oldest; one at least.
std::vector<std::size_t> recencies_of(const std::vector<GridScan>& scans) {
  std::set<std::size_t, std::greater<>> recencies;
  for (const GridScan& scan : scans) recencies.insert(scan.recency);
  if (recencies.empty()) return {0};
  return {recencies.begin(), recencies.end()};
}

/// Fills the grid. Returns where walls changed.
std::vector<ChangedPlace> fill(OccupancyGrid& grid,
                               const std::vector<GridScan>& scans,
                               const GridFromScansParams& params) {
  const std::size_t num_cells = grid.values().size();
  std::vector<std::uint16_t> num_hits(num_cells, 0);
  const CellCounts counts{grid.values(), num_hits};
  const std::vector<std::size_t> recencies = recencies_of(scans);
  count(grid, scans, recencies.front(), params, counts);
  std::vector<ChangedPlace> changes;
  if (recencies.size() > 1) {
    ChangedCells changed(
        grid.num_columns(), grid.num_rows(), grid.resolution_m(), params.insertion, params.changes);
    for (std::size_t s = 1; s < recencies.size(); ++s) {
      std::vector<float> older_passes(num_cells, 0.0F);
      std::vector<std::uint16_t> older_hits(num_cells, 0);
      const CellCounts older{older_passes, older_hits};
      count(grid, scans, recencies[s], params, older);
      changed.add_older(counts, older);
    }
    changes = changed.places(counts, grid.T_map_grid());
  }
  visit_bands(grid, params, [&](std::int32_t row, std::size_t first, std::size_t num_in_band) {
    EvidenceBand(row,
                 grid.num_columns(),
                 counts.num_passes.subspan(first, num_in_band),
                 counts.num_hits.subspan(first, num_in_band))
        .finish(params.insertion);
  });
  return changes;
}

}  // namespace

void GridFromScansParams::validate() const {
  if (!(resolution_m > 0.0)) throw ParameterError("resolution_m", "must be positive");
  if (!(min_spacing_m >= 0.0)) throw ParameterError("min_spacing_m", "must not be negative");
  if (!(min_turn_rad >= 0.0)) throw ParameterError("min_turn_rad", "must not be negative");
  if (!(margin_m >= 0.0)) throw ParameterError("margin_m", "must not be negative");
  if (!(max_num_cells >= 1e4 && max_num_cells <= static_cast<double>(OccupancyGrid::kMaxCells))) {
    throw ParameterError("max_num_cells", "must be between 10^4 and 4 * 10^8");
  }
  if (num_threads < 1) throw ParameterError("num_threads", "must be at least 1");
  beams.validate();
  insertion.validate();
  changes.validate();
}

OccupancyGrid grid_from_scans(std::span<const PlacedScan> scans,
                              double grid_heading_rad,
                              const GridFromScansParams& params) {
  return grid_with_changes(scans, grid_heading_rad, params).grid;
}

GridWithChanges grid_with_changes(std::span<const PlacedScan> scans,
                                  double grid_heading_rad,
                                  const GridFromScansParams& params) {
  params.validate();
  const Pose2 T_map_aligned{0.0, 0.0, grid_heading_rad};
  std::vector<GridScan> kept = aligned(spaced(scans, params), T_map_aligned.inverse(), params);
  OccupancyGrid grid = grid_over(kept, T_map_aligned, params);
  std::vector<ChangedPlace> changes = fill(grid, kept, params);
  return {std::move(grid), std::move(changes)};
}

}  // namespace setsquare
