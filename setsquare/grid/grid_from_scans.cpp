// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/grid/grid_from_scans.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Core>
#include <limits>
#include <vector>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

constexpr double kFarthest_m = 1e6;  // a pose beyond is no place in a building

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
      if (motion.translation().norm() < params.min_spacing_m &&
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

  void include(const Eigen::Vector2d& point) {
    low = low.min(point.array());
    high = high.max(point.array());
  }
};

OccupancyGrid grid_over(const Extent& extent,
                        const Pose2& T_map_aligned,
                        const GridFromScansParams& params) {
  const Eigen::Array2d low = extent.low - params.margin_m;
  const Eigen::Array2d size = extent.high - extent.low + 2.0 * params.margin_m;
  double resolution_m = params.resolution_m;
  const auto num_cells = [&] { return ((size / resolution_m).ceil() + 1.0).prod(); };
  while (num_cells() > params.max_num_cells) resolution_m *= 2.0;
  const Eigen::Array2d cells = (size / resolution_m).ceil() + 1.0;
  return {T_map_aligned * Pose2{low.x(), low.y(), 0.0},
          resolution_m,
          static_cast<std::int32_t>(cells.x()),
          static_cast<std::int32_t>(cells.y())};
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
  insertion.validate();
}

OccupancyGrid grid_from_scans(std::span<const PlacedScan> scans,
                              double grid_heading_rad,
                              const GridFromScansParams& params) {
  params.validate();
  const std::vector<PlacedScan> kept = spaced(scans, params);
  const Pose2 T_map_aligned{0.0, 0.0, grid_heading_rad};
  const Pose2 T_aligned_map = T_map_aligned.inverse();
  Extent extent;
  if (kept.empty()) extent.include(Eigen::Vector2d::Zero());
  for (const PlacedScan& placed : kept) {
    const Pose2 T_aligned_sensor = T_aligned_map * placed.T_map_sensor;
    extent.include(T_aligned_sensor.translation());
    for (const BeamEnd& end : beam_ends(*placed.scan, params.insertion)) {
      extent.include(T_aligned_sensor * Eigen::Vector2d(end.x_m, end.y_m));
    }
  }
  OccupancyGrid grid = grid_over(extent, T_map_aligned, params);
  for (const PlacedScan& placed : kept) {
    insert_scan(grid, placed.T_map_sensor, *placed.scan, params.insertion);
  }
  return grid;
}

}  // namespace setsquare
