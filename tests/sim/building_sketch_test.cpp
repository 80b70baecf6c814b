// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "setsquare/sim/building/sketch.hpp"

namespace setsquare::building_sketch_test {

double length_of_walls(const std::vector<Space>& spaces) {
  double length = 0.0;
  for (const PlanSegment& segment : wall_segments(spaces))
    length += (segment.end_m - segment.start_m).norm();
  return length;
}

TEST(BuildingSketchTest, WallsAreTheBoundaryOfTheUnion) {
  // Two rooms of 4 x 3 m with a wall of 0.2 m, and a doorway of 0.9 m through it.
  const Space left{rectangle({}, 0.0, 0.0, 4.0, 3.0), {}};
  const Space right{rectangle({}, 4.2, 0.0, 8.2, 3.0), {}};
  const Space doorway{rectangle({}, 3.98, 1.0, 4.22, 1.9), {}};
  EXPECT_NEAR(length_of_walls({left, right}), 28.0, 1e-9);
  EXPECT_NEAR(length_of_walls({left, right, doorway}), 28.0 - 2 * 0.9 + 2 * 0.2, 1e-4);
}

TEST(BuildingSketchTest, AWallWithinARoomVanishes) {
  const Space room{rectangle({}, 0.0, 0.0, 4.0, 3.0), {}};
  const Space inside{rectangle({1.0, 1.0, 0.3}, 0.0, 0.0, 1.0, 1.0), {}};
  EXPECT_NEAR(length_of_walls({room, inside}), 14.0, 1e-9);
}

TEST(BuildingShapesTest, ApartMeansByTheGap) {
  const ConvexPolygon square = rectangle({}, 0.0, 0.0, 1.0, 1.0);
  const ConvexPolygon line{{1.5, -1.0}, {1.5, 2.0}};
  EXPECT_TRUE(are_apart(square, line, 0.49));
  EXPECT_FALSE(are_apart(square, line, 0.51));
  EXPECT_FALSE(are_apart(square, box({0.5, 0.5, 0.7}, 0.1, 0.1), 0.0));
}

TEST(BuildingShapesTest, InsideIntervalOfALineThroughABox) {
  const ConvexPolygon square = rectangle({}, 1.0, -1.0, 3.0, 1.0);
  const InsideInterval inside = inside_interval(square, {0.0, 0.0}, {4.0, 0.0});
  EXPECT_NEAR(inside.first, 0.25, 1e-6);
  EXPECT_NEAR(inside.second, 0.75, 1e-6);
  EXPECT_TRUE(inside_interval(square, {0.0, 1.0}, {4.0, 1.0}).is_empty());
}

}  // namespace setsquare::building_sketch_test
