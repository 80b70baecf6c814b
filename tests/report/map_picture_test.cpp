// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/drawing/png.hpp"
#include "setsquare/report/map/picture.hpp"
#include "setsquare/report/map/raster.hpp"
#include "setsquare/report/palette.hpp"

namespace setsquare::map_picture_test {

/// A floor plan, its first line the highest row: '#' wall, '.' free, ' ' unknown. One cell per
/// metre.
OccupancyGrid grid_from_plan(const std::vector<std::string>& plan, const Pose2& T_map_grid = {}) {
  const auto num_rows = static_cast<std::int32_t>(plan.size());
  const auto num_columns = static_cast<std::int32_t>(plan.front().size());
  OccupancyGrid grid(T_map_grid, 1.0, num_columns, num_rows);
  for (CellIndex cell; cell.row < num_rows; ++cell.row) {
    for (cell.column = 0; cell.column < num_columns; ++cell.column) {
      const char letter = plan[static_cast<std::size_t>(num_rows - 1 - cell.row)]
                              [static_cast<std::size_t>(cell.column)];
      grid.values()[grid.index(cell)] = letter == '#' ? 3.0F : letter == '.' ? -2.0F : 0.0F;
    }
  }
  return grid;
}

const std::vector<std::string> kPlan = {"#####  ",  //
                                        "#...#  ",
                                        "#...###",
                                        "#.....#",
                                        "#######"};

/// No margin, no footer, one pixel per cell: the plan as it is.
const MapPictureParams kBare = {
    .min_side_px = 1, .margin_m = 0.0, .has_scale_bar = false, .has_legend = false};

std::int64_t count(const Image& image, Color value) {
  return std::count(image.pixels().begin(), image.pixels().end(), value);
}

MappedScan scan_at(const Pose2& T_map_base) {
  MappedScan scan;
  scan.T_map_base = T_map_base;
  return scan;
}

TEST(MapPicture, ShowsTheFloorPlanUpright) {
  const Image image = map_picture(grid_from_plan(kPlan), {}, kBare);
  ASSERT_EQ(image.width_px(), 7);
  ASSERT_EQ(image.height_px(), 5);
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 7; ++column) {
      const char letter = kPlan[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
      const Color expected = letter == '#'   ? palette::kWall
                             : letter == '.' ? palette::kFree
                                             : palette::kUnknown;
      EXPECT_EQ(image.at(column, row), expected) << column << ", " << row;
    }
  }
}

TEST(MapPicture, SmallMapsAreEnlargedAndLargeOnesJoined) {
  const CellBox small = {{0, 0}, {100, 50}};
  EXPECT_EQ(map_scale(small, 900, 4000).pixels_per_block, 4);
  const CellBox large = {{0, 0}, {9000, 500}};
  EXPECT_EQ(map_scale(large, 900, 4000).cells_per_block, 3);
  const CellBox medium = {{0, 0}, {1000, 500}};
  EXPECT_EQ(map_scale(medium, 900, 4000).pixels_per_cell(), 1.0);
}

TEST(MapPicture, HugeMapStaysWithinItsSideAndKeepsThinWalls) {
  OccupancyGrid grid({}, 0.05, 3000, 2000);
  for (std::int32_t column = 0; column < 3000; ++column) {
    for (std::int32_t row = 0; row < 2000; ++row) {
      const bool is_wall = row == 0 || row == 1999 || column == 0 || column == 2999 || row == 777;
      grid.values()[grid.index({column, row})] = is_wall ? 3.0F : -2.0F;
    }
  }
  MapPictureParams params = kBare;
  params.max_side_px = 400;
  const Image image = map_picture(grid, {}, params);
  EXPECT_LE(std::max(image.width_px(), image.height_px()), 400);
  bool has_inner_wall = false;
  for (int row = 20; row < image.height_px() - 20; ++row) {
    has_inner_wall = has_inner_wall || image.at(200, row) == palette::kWall;
  }
  EXPECT_TRUE(has_inner_wall);
}

TEST(MapPicture, PathLiesWhereTheRobotWasThoughTheGridIsAskew) {
  const Pose2 T_map_grid{12.0, -5.0, 0.6};
  const OccupancyGrid grid = grid_from_plan(kPlan, T_map_grid);
  const Pose2 T_grid_base{2.5, 1.5, 0.0};
  MapPictureParams params = kBare;
  params.min_side_px = 28;  // four pixels per cell
  const Trajectory standing(2, {{}, T_map_grid * T_grid_base});
  const Image image = map_picture(grid, standing, params);
  ASSERT_EQ(image.width_px(), 28);
  EXPECT_EQ(image.at(10, 14), palette::kEnd);
}

TEST(MapPicture, EachStatusHasItsColour) {
  OccupancyGrid grid({}, 0.1, 400, 400);
  std::fill(grid.values().begin(), grid.values().end(), -2.0F);
  Trajectory trajectory;
  std::vector<MappedScan> scans;
  for (int i = 0; i < 90; ++i) {
    trajectory.push_back({{}, {2.0 + 0.4 * i, 20.0, 0.0}});
    scans.push_back(scan_at(trajectory.back().pose));
    scans.back().status = i < 30   ? TrackStatus::kTracked
                          : i < 60 ? TrackStatus::kDegenerate
                                   : TrackStatus::kLost;
  }
  MapPictureParams params = kBare;
  params.min_side_px = 1600;
  const Image marked = layered_map_picture(grid, {.scans = scans, .closures = {}}, params);
  for (const Color value : {palette::kTracked, palette::kDegenerate, palette::kLost}) {
    EXPECT_GT(count(marked, value), 300);
  }
  const Image plain = map_picture(grid, trajectory, params);
  EXPECT_GT(count(plain, palette::kTracked), 900);
  EXPECT_EQ(count(plain, palette::kLost), 0);
}

TEST(MapPicture, WhatIsNotPlacedIsNotDrawn) {
  const std::vector<std::string> hall(60, std::string(60, '.'));
  const OccupancyGrid grid = grid_from_plan(hall);
  std::vector<MappedScan> path;
  for (int i = 0; i < 40; ++i) {
    path.push_back(scan_at({10.0 + i, 20.0, 0.0}));
    path.back().stamp = Timestamp{i};
  }
  MapPictureParams params = kBare;
  params.has_legend = true;
  const Image before = layered_map_picture(grid, {.scans = path, .closures = {}}, params);
  // Lines all over the map and far beyond it, first, last and between.
  for (const std::size_t at : {0U, 17U, 41U}) {
    for (const double x_m : {-200.0, 50.0, 200.0}) {
      MappedScan nowhere = scan_at({x_m, -150.0, 0.0});
      nowhere.is_placed = false;
      path.insert(path.begin() + static_cast<std::ptrdiff_t>(at), nowhere);
    }
  }
  const Image after = layered_map_picture(grid, {.scans = path, .closures = {}}, params);
  ASSERT_EQ(after.pixels().size(), before.pixels().size());
  std::size_t num_different = 0;
  for (std::size_t i = 0; i < before.pixels().size(); ++i) {
    num_different += before.pixels()[i] != after.pixels()[i];
  }
  EXPECT_LT(num_different, 25U) << "the path has a gap where nothing is placed, and no more";
}

TEST(MapPicture, ThePathDoesNotCrossTheLegend) {
  const OccupancyGrid grid = grid_from_plan(std::vector<std::string>(60, std::string(60, '.')));
  MapPictureParams params = kBare;
  params.has_legend = true;
  const Trajectory within = {{Timestamp{0}, {30.0, 30.0, 0.0}}, {Timestamp{1}, {30.0, 20.0, 0.0}}};
  Trajectory beyond = within;
  beyond.insert(beyond.begin() + 1, {Timestamp{2}, {30.0, -500.0, 0.0}});
  const Image image = map_picture(grid, within, params);
  const Image other = map_picture(grid, beyond, params);
  ASSERT_EQ(other.height_px(), image.height_px());
  for (int row = 60; row < image.height_px(); ++row) {
    for (int column = 0; column < image.width_px(); ++column) {
      ASSERT_EQ(other.at(column, row), image.at(column, row)) << column << ", " << row;
    }
  }
}

TEST(MapPicture, ScaleBarHasARoundLength) {
  OccupancyGrid grid({}, 0.05, 1000, 600);
  std::fill(grid.values().begin(), grid.values().end(), -2.0F);
  const Image image = map_picture(grid, {}, {.margin_m = 0.0, .has_legend = false});
  // One pixel per cell, so 10 m are 200 pixels, and the bar has a rim of 1.5.
  int longest_run = 0;
  for (int row = 600; row < image.height_px(); ++row) {
    int run = 0;
    for (int column = 0; column < image.width_px(); ++column) {
      run = image.at(column, row) == palette::kInk ? run + 1 : 0;
      longest_run = std::max(longest_run, run);
    }
  }
  EXPECT_NEAR(longest_run, 200 + 3, 1);
}

TEST(MapPicture, SameInputSameBytes) {
  const OccupancyGrid grid = grid_from_plan(kPlan);
  const Trajectory trajectory = {{{}, {1.5, 1.5, 0.0}}, {{}, {4.5, 1.5, 0.0}}};
  EXPECT_EQ(png_from_image(map_picture(grid, trajectory)),
            png_from_image(map_picture(grid, trajectory)));
}

TEST(MapPicture, NothingKnownIsStillAPicture) {
  const Image image = map_picture(OccupancyGrid({}, 0.05, 20, 20), {});
  EXPECT_GT(count(image, palette::kUnknown), 100);
  EXPECT_THROW(MapPictureParams{.max_side_px = 3}.validate(), ParameterError);
}

}  // namespace setsquare::map_picture_test
