// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/point_slice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"

namespace setsquare::point_slice_test {

using ros::PointCloud2;
using ros::PointSlicer;
using ros::SensorPoints;
using ros::SliceKind;
using ros::SliceParams;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Point {
  float x_m = 0.0F;
  float y_m = 0.0F;
  float z_m = 0.0F;
  std::uint16_t ring = 0;
};

/// A message and the bytes that its data point to.
struct Cloud {
  std::string bytes;
  PointCloud2 message;
};

Cloud cloud(const std::vector<Point>& points, std::uint32_t height = 1) {
  constexpr std::uint32_t kStep = 16;
  Cloud made;
  for (const Point& point : points) {
    made.bytes.append(reinterpret_cast<const char*>(&point), 14).append(2, '\x7f');
  }
  made.message.stamp = {5};
  made.message.fields = {{"x", 0, 7, 1}, {"y", 4, 7, 1}, {"z", 8, 7, 1}, {"ring", 12, 4, 1}};
  made.message.height = height;
  made.message.width = static_cast<std::uint32_t>(points.size()) / height;
  made.message.point_step_bytes = kStep;
  made.message.row_step_bytes = kStep * made.message.width;
  made.message.data = {made.bytes, ros::Primitive::kUint8, false};
  return made;
}

Point polar(double bearing_rad, double range_m, double z_m = 0.0, std::uint16_t ring = 0) {
  return {static_cast<float>(range_m * std::cos(bearing_rad)),
          static_cast<float>(range_m * std::sin(bearing_rad)),
          static_cast<float>(z_m),
          ring};
}

Eigen::Isometry3d at_height(double z_m, double roll_rad = 0.0, double yaw_rad = 0.0) {
  return Eigen::Translation3d(0.25, -0.5, z_m) *
         Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX());
}

std::size_t num_returns(const Scan& scan) {
  std::size_t num = 0;
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    num += scan.outcome(beam) == BeamOutcome::kReturn ? 1 : 0;
  }
  return num;
}

TEST(ReadPoints, FieldsOfAnyTypeOrderAndByteOrder) {
  std::string bytes(2 * 20, '\0');
  const auto put = [&bytes](std::size_t offset, auto value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    std::reverse(raw, raw + sizeof value);
    bytes.replace(offset, sizeof value, raw, sizeof value);
  };
  put(0, std::int16_t{3});
  put(2, 2.5);
  put(10, -1.5F);
  put(14, std::uint8_t{9});
  put(20, std::int16_t{-4});
  put(22, 0.5);
  put(30, std::numeric_limits<float>::quiet_NaN());
  PointCloud2 message;
  message.fields = {{"y", 2, 8, 1}, {"x", 0, 3, 1}, {"z", 10, 7, 1}, {"channel", 14, 2, 1}};
  message.height = 1;
  message.width = 2;
  message.point_step_bytes = 20;
  message.is_bigendian = true;
  message.data = {bytes, ros::Primitive::kUint8, false};
  SensorPoints points;
  ASSERT_THAT(ros::read_points(message, points), IsEmpty());
  EXPECT_THAT(points.x_m, ElementsAre(3.0F));
  EXPECT_THAT(points.y_m, ElementsAre(2.5F));
  EXPECT_THAT(points.z_m, ElementsAre(-1.5F));
  EXPECT_THAT(points.rings, ElementsAre(9));
}

TEST(ReadPoints, SizesThatLieAreRefused) {
  const Cloud good = cloud({polar(0.0, 1.0), polar(0.5, 2.0), polar(1.0, 3.0), polar(1.5, 4.0)}, 2);
  SensorPoints points;
  ASSERT_THAT(ros::read_points(good.message, points), IsEmpty());
  EXPECT_EQ(points.size(), 4U);
  constexpr std::uint32_t kHuge = std::numeric_limits<std::uint32_t>::max();
  const auto fault = [&](const auto& change) {
    PointCloud2 message = good.message;
    change(message);
    return std::string(ros::read_points(message, points));
  };
  EXPECT_THAT(fault([](PointCloud2& m) { m.width = kHuge; }), ::testing::Not(IsEmpty()));
  EXPECT_THAT(fault([](PointCloud2& m) { m.height = kHuge; }), HasSubstr("fewer bytes"));
  EXPECT_THAT(fault([](PointCloud2& m) { m.height = 3; }), HasSubstr("fewer bytes"));
  EXPECT_THAT(fault([](PointCloud2& m) { m.row_step_bytes = 0; }), HasSubstr("overlap"));
  EXPECT_THAT(fault([](PointCloud2& m) { m.row_step_bytes = kHuge; }), HasSubstr("fewer bytes"));
  EXPECT_THAT(fault([](PointCloud2& m) { m.point_step_bytes = 0; }), HasSubstr("no x and y"));
  EXPECT_THAT(fault([](PointCloud2& m) { m.fields[0].offset_bytes = kHuge; }), HasSubstr("no x"));
  EXPECT_THAT(fault([](PointCloud2& m) { m.fields[0].datatype = 9; }), HasSubstr("no x and y"));
  EXPECT_THAT(fault([](PointCloud2& m) { m.data.bytes = {}; }), HasSubstr("fewer bytes"));
  PointCloud2 nothing = good.message;
  nothing.width = 0;
  nothing.height = kHuge;
  EXPECT_THAT(ros::read_points(nothing, points), IsEmpty());
  EXPECT_EQ(points.size(), 0U);
}

TEST(PointSlicer, ThePointsOfAPlanarScannerBecomeItsBeams) {
  for (const double step_deg : {0.25, 0.36, 1.0, 0.7}) {
    const double step_rad = rad_from_deg(step_deg);
    std::vector<Point> points;
    for (int i = 0; i < 270; ++i) {
      if (i % 7 != 3) points.push_back(polar(-1.5 + i * step_rad, 2.0 + 0.01 * i));
    }
    PointSlicer slicer({});
    Scan scan;
    const Cloud flat = cloud(points);
    ASSERT_THAT(slicer.slice(flat.message, at_height(0.3), scan), IsEmpty());
    EXPECT_EQ(slicer.kind(), SliceKind::kPlane);
    EXPECT_NO_THROW(scan.validate());
    EXPECT_NEAR(scan.bearing_step_rad, step_rad, 0.001 * step_rad);
    EXPECT_EQ(scan.stamp, Timestamp{5});
    EXPECT_EQ(scan.T_base_sensor, (Pose2{0.25, -0.5, 0.0}));
    EXPECT_EQ(num_returns(scan), points.size()) << step_deg;
    for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
      if (scan.outcome(beam) != BeamOutcome::kReturn) continue;
      const double from_first_rad = scan.bearing_rad(beam) + 1.5;
      const double i =
          std::round((from_first_rad + (from_first_rad < -0.01 ? kTwoPi : 0.0)) / step_rad);
      EXPECT_NEAR(scan.ranges_m[beam], 2.0 + 0.01 * i, 1e-5);
    }
  }
}

TEST(PointSlicer, AHangingAndTurnedSensorIsSeenFromAbove) {
  const Eigen::Isometry3d T_base_sensor = at_height(0.3, kPi, 0.5);
  const Cloud flat = cloud({polar(0.2, 2.0), polar(0.3, 3.0), polar(0.4, 4.0)});
  PointSlicer slicer({});
  Scan scan;
  ASSERT_THAT(slicer.slice(flat.message, T_base_sensor, scan), IsEmpty());
  std::vector<double> bearings_rad;
  for (std::size_t beam = 0; beam < scan.num_beams(); ++beam) {
    if (scan.outcome(beam) == BeamOutcome::kReturn) bearings_rad.push_back(scan.bearing_rad(beam));
  }
  ASSERT_EQ(bearings_rad.size(), 3U);
  EXPECT_NEAR(bearings_rad[0], 0.5 - 0.4, 0.06);
  EXPECT_NEAR(bearings_rad[2], 0.5 - 0.2, 0.06);
}

/// A room of 6 x 6 m with a floor, from a scanner of eight rings 1 m above the floor.
std::vector<Point> room_of_rings() {
  std::vector<Point> points;
  for (std::uint16_t ring = 0; ring < 8; ++ring) {
    const double elevation_rad = rad_from_deg(-14.0 + 4.0 * ring);
    for (int i = 0; i < 720; ++i) {
      const double bearing_rad = rad_from_deg(0.5 * i) + 0.001;
      const double wall_m =
          3.0 / std::max(std::abs(std::cos(bearing_rad)), std::abs(std::sin(bearing_rad)));
      const double floor_m =
          elevation_rad < 0.0 ? 1.0 / std::tan(-elevation_rad) : std::numeric_limits<double>::max();
      const double range_m = std::min(wall_m, floor_m);
      points.push_back(polar(bearing_rad, range_m, range_m * std::tan(elevation_rad), ring));
    }
  }
  points.push_back(polar(0.001, 1.5, -0.5, 1));  // A box in front of the wall.
  return points;
}

TEST(PointSlicer, AHeightSliceSeesTheNearestOfWallsAndBoxesButNotTheFloor) {
  const Cloud room = cloud(room_of_rings());
  PointSlicer slicer(SliceParams{.kind = SliceKind::kHeights, .low_m = 0.2, .high_m = 1.5});
  Scan scan;
  ASSERT_THAT(slicer.slice(room.message, at_height(1.0), scan), IsEmpty());
  EXPECT_EQ(scan.num_beams(), 720U);
  EXPECT_EQ(num_returns(scan), 720U);
  const auto straight_ahead = static_cast<std::size_t>(
      std::round((0.001 - scan.first_bearing_rad) / scan.bearing_step_rad));
  EXPECT_NEAR(scan.ranges_m[straight_ahead], 1.5, 1e-5);
  EXPECT_NEAR(scan.ranges_m[straight_ahead + 1], 3.0, 0.01);
}

TEST(PointSlicer, ARingIsTakenAlone) {
  const Cloud room = cloud(room_of_rings());
  PointSlicer slicer(SliceParams{.kind = SliceKind::kRing, .ring = 4});
  Scan scan;
  ASSERT_THAT(slicer.slice(room.message, at_height(1.0), scan), IsEmpty());
  EXPECT_EQ(num_returns(scan), 720U);
  for (const double range_m : scan.ranges_m) EXPECT_GT(range_m, 2.9);
  PointSlicer missing(SliceParams{.kind = SliceKind::kRing, .ring = 40});
  EXPECT_THAT(missing.slice(room.message, at_height(1.0), scan), HasSubstr("no points"));
}

TEST(PointSlicer, AutoTakesHeightsAroundTheSensorOfAScannerInSpace) {
  const Cloud room = cloud(room_of_rings());
  PointSlicer slicer({});
  Scan scan;
  ASSERT_THAT(slicer.slice(room.message, at_height(1.0), scan), IsEmpty());
  EXPECT_EQ(slicer.kind(), SliceKind::kHeights);
  for (const double range_m : scan.ranges_m) EXPECT_GT(range_m, 2.9);
}

TEST(PointSlicer, LaterCloudsHaveTheFirstOnesBins) {
  PointSlicer slicer({});
  Scan first;
  Scan second;
  const Cloud many = cloud({polar(0.0, 2.0), polar(0.01, 2.0), polar(0.02, 2.0), polar(0.03, 2.0)});
  const Cloud few = cloud({polar(3.1, 2.0), polar(-3.1, 2.5)});
  ASSERT_THAT(slicer.slice(many.message, at_height(0.0), first), IsEmpty());
  ASSERT_THAT(slicer.slice(few.message, at_height(0.0), second), IsEmpty());
  EXPECT_EQ(first.num_beams(), second.num_beams());
  EXPECT_EQ(first.first_bearing_rad, second.first_bearing_rad);
  EXPECT_EQ(num_returns(second), 2U);
}

TEST(PointSlicer, WhatGivesNoScanSaysWhy) {
  PointSlicer slicer({});
  Scan scan;
  const Cloud flat = cloud({polar(0.0, 2.0), polar(0.1, 2.0)});
  EXPECT_THAT(slicer.slice(cloud({}).message, at_height(0.0), scan), HasSubstr("no points"));
  EXPECT_THAT(slicer.slice(flat.message, at_height(0.0, kQuarterTurn), scan),
              HasSubstr("not horizontal"));
  EXPECT_THROW(PointSlicer(SliceParams{.low_m = 1.0, .high_m = 0.5}), ParameterError);
  EXPECT_THROW(PointSlicer(SliceParams{.bin_width_rad = 0.0}), ParameterError);
}

}  // namespace setsquare::point_slice_test
