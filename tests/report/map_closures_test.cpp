// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "setsquare/drawing/png.hpp"
#include "setsquare/report/map/closures.hpp"
#include "setsquare/report/map/picture.hpp"
#include "setsquare/report/palette.hpp"

namespace setsquare::map_closures_test {

Timestamp at_second(int second) { return timestamp_from_seconds(second); }

constexpr double kHalfPixel_m = 0.0125;  // lines meet pixels' middles

/// A robot that drives 20 m along y = 5 m and back along y = 15 m in an open room of 30 m x 20 m,
/// one pose per metre and per second.
class ClosedLoop : public ::testing::Test {
 protected:
  void SetUp() override {
    std::ranges::fill(grid_.values(), -2.0F);
    for (int i = 0; i < 42; ++i) {
      const double x_m = (i < 21 ? 5.0 + i : 25.0 - (i - 21)) + kHalfPixel_m;
      trajectory_.push_back({at_second(i), {x_m, i < 21 ? 5.0 : 15.0, 0.0}});
    }
  }

  /// The closure of two poses opposite each other.
  static LoopClosure closure(int i, double weight = 1.0, ClosureAxes axes = ClosureAxes::kXY) {
    return {.stamp_i = at_second(i),
            .stamp_j = at_second(41 - i),
            .T_i_j = {0.0, 10.0, 0.0},
            .axes = axes,
            .is_accepted = true,
            .weight = weight,
            .reason = "matched"};
  }
  [[nodiscard]] Image picture(const std::vector<LoopClosure>& closures) const {
    MapPictureParams params;
    params.min_side_px = 1200;
    params.margin_m = 0.0;
    std::vector<MappedScan> scans;
    for (const StampedPose& pose : trajectory_) {
      scans.push_back({.stamp = pose.stamp, .T_map_sensor = pose.pose, .T_map_base = pose.pose});
    }
    return layered_map_picture(grid_, {.scans = scans, .closures = closures}, params);
  }
  [[nodiscard]] PlacedClosures placed(const std::vector<LoopClosure>& closures) const {
    return placed_closures(closures, trajectory_, path_in_cells(grid_, trajectory_));
  }
  static std::vector<std::string> words(const PlacedClosures& closures) {
    std::vector<std::string> words;
    for (const LegendEntry& entry : legend_entries(closures)) words.push_back(entry.words);
    return words;
  }
  static std::int64_t count(const Image& image, Color value) {
    return std::ranges::count(image.pixels(), value);
  }

  OccupancyGrid grid_{{}, 0.05, 600, 400};
  Trajectory trajectory_;
};

TEST_F(ClosedLoop, ClosuresLieBetweenThePosesOfTheirStamps) {
  const PlacedClosures found = placed({closure(3)});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].from_cells.isApprox(Eigen::Vector2d(8.0 + kHalfPixel_m, 5.0) / 0.05));
  EXPECT_TRUE(found[0].to_cells.isApprox(Eigen::Vector2d(8.0 + kHalfPixel_m, 15.0) / 0.05));
}

TEST_F(ClosedLoop, RefusedOnesAndThoseOfUnknownStampsAreLeftOut) {
  LoopClosure refused = closure(3);
  refused.is_accepted = false;
  LoopClosure elsewhere = closure(3);
  elsewhere.stamp_j = at_second(1000);
  EXPECT_TRUE(placed({refused, elsewhere}).empty());
  EXPECT_EQ(picture({refused, elsewhere}).pixels(), picture({}).pixels());
}

TEST_F(ClosedLoop, AClosureIsALineAcrossTheRoomInItsKindsColour) {
  // 2 pixels per cell, 40 per metre: the line is 400 long, its legend is far below the room.
  const std::int64_t without = count(picture({}), palette::kClosure);
  EXPECT_EQ(without, 0);
  EXPECT_GT(count(picture({closure(3)}), palette::kClosure), 350);
  EXPECT_EQ(count(picture({closure(3)}), palette::kAxisClosure), 0);
  const Image of_axis = picture({closure(3, 1.0, ClosureAxes::kX)});
  EXPECT_GT(count(of_axis, palette::kAxisClosure), 350);
  EXPECT_EQ(count(of_axis, palette::kClosure), 0);
  const Image image = picture({closure(3)});
  EXPECT_EQ(image.at(8 * 40, 10 * 40), palette::kClosure) << "at x = 8 m, half way up";
}

TEST_F(ClosedLoop, WhatWeighsLessIsPalerAndLiesBelow) {
  const auto green = [this](double weight) {
    return picture({closure(3, weight)}).at(8 * 40, 10 * 40).red;
  };
  EXPECT_GT(green(0.1), green(0.4));
  EXPECT_GT(green(0.4), green(1.0));
  EXPECT_LT(green(0.1), 255) << "still seen";
}

TEST_F(ClosedLoop, TheLegendNamesTheKindsThatAreThere) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(words(placed({})), Words{});
  EXPECT_EQ(words(placed({closure(1), closure(2)})), Words{"loop closure"});
  EXPECT_EQ(words(placed({closure(1), closure(2, 0.5, ClosureAxes::kY)})),
            (Words{"loop closure", "closure of one axis"}));
}

TEST_F(ClosedLoop, SameClosuresSameBytes) {
  std::vector<LoopClosure> closures;
  for (int i = 0; i < 20; ++i) closures.push_back(closure(i, 0.05 * i));
  EXPECT_EQ(png_from_image(picture(closures)), png_from_image(picture(closures)));
}

}  // namespace setsquare::map_closures_test
