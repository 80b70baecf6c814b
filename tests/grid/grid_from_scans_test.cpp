// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/grid/grid_from_scans.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "setsquare/core/error.hpp"
#include "tests/support/rectangular_room.hpp"

namespace setsquare::grid_from_scans_test {

constexpr double kWidth_m = 9.97;
constexpr double kDepth_m = 6.97;

/// Scans of one room that lies at an angle in the map, along a path through it.
class AskewRoom : public ::testing::Test {
 protected:
  void SetUp() override {
    for (int i = 0; i < 20; ++i) {
      const Pose2 T_room_sensor{1.0 + 0.35 * i, 2.0 + 0.1 * i, 0.2 * i};
      scans_.push_back(testing::scan_of_room(T_room_sensor, kWidth_m, kDepth_m, 360));
      poses_.push_back(T_map_room_ * T_room_sensor);
    }
    for (std::size_t i = 0; i < scans_.size(); ++i) placed_.push_back({&scans_[i], poses_[i]});
  }

  const Pose2 T_map_room_{5.0, -3.0, 0.3};
  std::vector<Scan> scans_;
  std::vector<Pose2> poses_;
  std::vector<PlacedScan> placed_;
};

TEST_F(AskewRoom, AlignedGridHoldsUprightWallsAndFreeSpaceWithin) {
  const OccupancyGrid grid = grid_from_scans(placed_, 0.3);
  const Pose2 T_room_grid = T_map_room_.inverse() * grid.T_map_grid();
  EXPECT_NEAR(T_room_grid.theta_rad, 0.0, 1e-12);
  int num_occupied = 0;
  int num_free = 0;
  for (CellIndex cell; cell.row < grid.num_rows(); ++cell.row) {
    for (cell.column = 0; cell.column < grid.num_columns(); ++cell.column) {
      const Eigen::Vector2d middle =
          T_room_grid * Eigen::Vector2d((cell.column + 0.5) * grid.resolution_m(),
                                        (cell.row + 0.5) * grid.resolution_m());
      const double inside_m = std::min(std::min(middle.x(), kWidth_m - middle.x()),
                                       std::min(middle.y(), kDepth_m - middle.y()));
      const CellState state = grid.state(cell);
      if (inside_m < -0.03) {
        EXPECT_EQ(state, CellState::kUnknown);
      }
      if (inside_m > 0.05) {
        EXPECT_EQ(state, CellState::kFree);
      }
      num_occupied += state == CellState::kOccupied ? 1 : 0;
      num_free += state == CellState::kFree ? 1 : 0;
    }
  }
  EXPECT_GT(num_occupied, 0.95 * 2.0 * (kWidth_m + kDepth_m) / grid.resolution_m());
  EXPECT_NEAR(num_free * 0.05 * 0.05, kWidth_m * kDepth_m, 0.05 * kWidth_m * kDepth_m);
}

TEST_F(AskewRoom, SameScansSameBytesByAnyNumberOfThreadsAndInAnyOrder) {
  const GridFromScansParams every_scan = {.min_spacing_m = 0.0, .min_turn_rad = 0.0};
  const OccupancyGrid one = grid_from_scans(placed_, 0.3, every_scan);
  for (const int num_threads : {1, 2, 3, 7, 200}) {
    GridFromScansParams params = every_scan;
    params.num_threads = num_threads;
    EXPECT_EQ(grid_from_scans(placed_, 0.3, params).values(), one.values()) << num_threads;
  }
  std::reverse(placed_.begin(), placed_.end());
  EXPECT_EQ(grid_from_scans(placed_, 0.3, every_scan).values(), one.values());
  EXPECT_THROW(static_cast<void>(grid_from_scans(placed_, 0.3, {.num_threads = 0})),
               ParameterError);
}

TEST_F(AskewRoom, TheCornerLiesAtWholeCentimetres) {
  const Pose2 corner = grid_from_scans(placed_).T_map_grid();
  EXPECT_EQ(corner.theta_rad, 0.0);
  EXPECT_EQ(corner.x_m, std::round(corner.x_m * 100.0) / 100.0);
  EXPECT_EQ(corner.y_m, std::round(corner.y_m * 100.0) / 100.0);
}

TEST_F(AskewRoom, ScansThatDidNotMoveAddNothing) {
  std::vector<PlacedScan> doubled;
  for (const PlacedScan& placed : placed_) doubled.insert(doubled.end(), 3, placed);
  EXPECT_EQ(grid_from_scans(doubled).values(), grid_from_scans(placed_).values());
  const GridFromScansParams every_scan = {.min_spacing_m = 0.0, .min_turn_rad = 0.0};
  EXPECT_NE(grid_from_scans(doubled, 0.0, every_scan).values(),
            grid_from_scans(placed_, 0.0, every_scan).values());
}

TEST_F(AskewRoom, CellsGrowUntilTheyAreFewEnough) {
  const OccupancyGrid grid = grid_from_scans(placed_, 0.3, {.max_num_cells = 1e4});
  EXPECT_LE(grid.values().size(), 10'000U);
  EXPECT_DOUBLE_EQ(grid.resolution_m(), 0.1);
}

TEST_F(AskewRoom, PosesThatAreNoPlacesAreLeftOut) {
  std::vector<PlacedScan> with_bad = placed_;
  with_bad.push_back({&scans_[0], {std::nan(""), 0.0, 0.0}});
  with_bad.push_back({&scans_[0], {1e300, 0.0, 0.0}});
  EXPECT_EQ(grid_from_scans(with_bad).values(), grid_from_scans(placed_).values());
}

TEST(GridFromScans, NothingGivesASmallUnknownGrid) {
  const OccupancyGrid grid = grid_from_scans({});
  EXPECT_GT(grid.values().size(), 0U);
  for (const float value : grid.values()) EXPECT_EQ(value, 0.0F);
  EXPECT_THROW(static_cast<void>(grid_from_scans({}, 0.0, {.resolution_m = -1.0})), ParameterError);
}

}  // namespace setsquare::grid_from_scans_test
