// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// How well the grid shows a building that is known: simulated scans at poses as a mapper gives
// them, a few centimetres off.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "setsquare/grid/grid_from_scans.hpp"
#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/sensing/robot_path.hpp"
#include "setsquare/sim/sensing/scanner_model.hpp"
#include "setsquare/sim/sensing/simulated_scan.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::grid_quality_test {

/// What was found of the walls that at least five returns came from.
struct Found {
  double wall_share = 0.0;   ///< Of their length, within a cell of an occupied one.
  double ghost_share = 0.0;  ///< Of the occupied cells, more than two cells from any wall.
  double behind_m2 = 0.0;    ///< Free, though no beam that returned came near.
};

class SimulatedOffice {
 public:
  SimulatedOffice(std::uint64_t seed, double dropout_share)
      : building_(make_building(BuildingClass::kOffice, seed)) {
    ScannerModel scanner = low_cost_360();
    scanner.dropout_share = dropout_share;
    const RobotPath path(building_.route_m);
    const RayCaster caster(building_.plan);
    std::mt19937_64 generator = testing::make_generator();
    std::normal_distribution<double> normal;
    const auto wobble = [&](double sigma) { return sigma * normal(generator); };
    for (const double time_s : sample_times(path, 0.1, rad_from_deg(5.0))) {
      Random random(sub_seed(seed, scans_.size()));
      const SimulatedScan simulated =
          simulate_scan(caster, building_.people, scanner, path, time_s, random);
      scans_.push_back(simulated.scan);
      const Pose2& pose = simulated.T_map_base;
      poses_.push_back(pose * simulated.scan.T_base_sensor *
                       Pose2{wobble(0.015), wobble(0.015), wobble(rad_from_deg(0.2))});
    }
  }

  [[nodiscard]] OccupancyGrid grid() const { return grid_from_scans(placed(scans_)); }
  [[nodiscard]] Found compare(const OccupancyGrid& grid) const;

 private:
  [[nodiscard]] std::vector<PlacedScan> placed(const std::vector<Scan>& scans) const {
    std::vector<PlacedScan> placed;
    for (std::size_t i = 0; i < scans.size(); ++i) placed.push_back({&scans[i], poses_[i]});
    return placed;
  }
  [[nodiscard]] std::vector<int> num_returns_by_cell(const OccupancyGrid& grid) const;
  [[nodiscard]] double free_behind_walls_m2(const OccupancyGrid& grid) const;

  Building building_;
  std::vector<Scan> scans_;
  std::vector<Pose2> poses_;
};

CellIndex cell_at(const OccupancyGrid& grid, const Eigen::Vector2d& p_map) {
  const Eigen::Vector2d p = grid.T_map_grid().inverse() * p_map / grid.resolution_m();
  return cell_of(subcell_at(p.x(), p.y()));
}

/// Calls visit(cell) for the cells of the grid at most `reach` away.
template <typename Visit>
void visit_around(const OccupancyGrid& grid, CellIndex middle, std::int32_t reach, Visit visit) {
  for (std::int32_t row = -reach; row <= reach; ++row) {
    for (std::int32_t column = -reach; column <= reach; ++column) {
      const CellIndex cell{middle.column + column, middle.row + row};
      if (grid.contains(cell)) visit(cell);
    }
  }
}

std::vector<int> SimulatedOffice::num_returns_by_cell(const OccupancyGrid& grid) const {
  std::vector<int> counts(grid.values().size(), 0);
  for (std::size_t i = 0; i < scans_.size(); ++i) {
    for (const BeamEnd& end : beam_ends(scans_[i])) {
      const CellIndex cell = cell_at(grid, poses_[i] * Eigen::Vector2d(end.x_m, end.y_m));
      if (end.is_return && grid.contains(cell)) ++counts[grid.index(cell)];
    }
  }
  return counts;
}

double SimulatedOffice::free_behind_walls_m2(const OccupancyGrid& grid) const {
  std::vector<Scan> returns_only = scans_;
  for (Scan& scan : returns_only) {
    for (double& range_m : scan.ranges_m) {
      if (range_m >= scan.max_range_m) range_m = std::nan("");
    }
  }
  const OccupancyGrid seen = grid_from_scans(placed(returns_only));
  double area_m2 = 0.0;
  for (CellIndex cell; cell.row < grid.num_rows(); ++cell.row) {
    for (cell.column = 0; cell.column < grid.num_columns(); ++cell.column) {
      if (grid.log_odds(cell) > -1.4F) continue;  // a probability below map_server's 0.196
      const Eigen::Vector2d middle(cell.column + 0.5, cell.row + 0.5);
      bool is_seen = false;
      visit_around(seen,
                   cell_at(seen, grid.T_map_grid() * (middle * grid.resolution_m())),
                   2,
                   [&](CellIndex near) { is_seen = is_seen || seen.log_odds(near) != 0.0F; });
      area_m2 += is_seen ? 0.0 : grid.resolution_m() * grid.resolution_m();
    }
  }
  return area_m2;
}

Found SimulatedOffice::compare(const OccupancyGrid& grid) const {
  const std::vector<int> num_returns = num_returns_by_cell(grid);
  std::vector<bool> is_near_wall(grid.values().size(), false);
  double num_seen = 0.0;
  double num_found = 0.0;
  for (const PlanSegment& segment : building_.plan.segments) {
    const Eigen::Vector2d along = segment.end_m - segment.start_m;
    const double num_samples = std::ceil(along.norm() / 0.025);
    for (double i = 0.5; i < num_samples; ++i) {
      const CellIndex cell = cell_at(grid, segment.start_m + along * (i / num_samples));
      int returns = 0;
      bool is_found = false;
      visit_around(grid, cell, 2, [&](CellIndex near) { is_near_wall[grid.index(near)] = true; });
      visit_around(grid, cell, 1, [&](CellIndex near) {
        returns += num_returns[grid.index(near)];
        is_found = is_found || grid.state(near) == CellState::kOccupied;
      });
      if (returns < 5 || segment.material == Material::kGlass) continue;
      num_seen += 1.0;
      num_found += is_found;
    }
  }
  double num_occupied = 0.0;
  double num_ghosts = 0.0;
  for (std::size_t i = 0; i < grid.values().size(); ++i) {
    if (grid.values()[i] <= 0.0F) continue;
    num_occupied += 1.0;
    num_ghosts += !is_near_wall[i];
  }
  return {num_found / num_seen, num_ghosts / num_occupied, free_behind_walls_m2(grid)};
}

TEST(GridQuality, ShowsTheWallsOfASimulatedOfficeAndNoOthers) {
  const SimulatedOffice office(1, 0.01);
  const Found found = office.compare(office.grid());
  EXPECT_GT(found.wall_share, 0.93);
  EXPECT_LT(found.ghost_share, 0.02);
}

TEST(GridQuality, DropOutsNeitherEraseWallsNorClearWhatLiesBehindThem) {
  const SimulatedOffice office(2, 0.05);
  const OccupancyGrid grid = office.grid();
  const Found found = office.compare(grid);
  EXPECT_GT(found.wall_share, 0.93);
  EXPECT_LT(found.ghost_share, 0.02);
  EXPECT_LT(found.behind_m2, 2.0);
}

}  // namespace setsquare::grid_quality_test
