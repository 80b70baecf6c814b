// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/transform_tree.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "setsquare/core/angle.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::transform_tree_test {

using ros::LookupStatus;
using ros::TransformFault;
using ros::TransformStamped;
using ros::TransformTree;
using ::testing::HasSubstr;
using ::testing::SizeIs;

TransformStamped transform(const std::string& parent,
                           const std::string& child,
                           double seconds = 0.0,
                           double x_m = 0.0,
                           double yaw_rad = 0.0) {
  TransformStamped stamped;
  stamped.stamp = timestamp_from_seconds(seconds);
  stamped.frame_id = parent;
  stamped.child_frame_id = child;
  stamped.translation_m.x() = x_m;
  stamped.rotation = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ());
  return stamped;
}

Timestamp at(double seconds) { return timestamp_from_seconds(seconds); }

double yaw_rad(const Eigen::Isometry3d& T) { return std::atan2(T(1, 0), T(0, 0)); }

/// odom -> base moves by 1 m/s and 0.1 rad/s from 10 s to 20 s; base -> laser stands still.
TransformTree robot() {
  TransformTree tree;
  for (int i = 0; i <= 10; ++i) {
    EXPECT_EQ(tree.add(transform("odom", "base", 10.0 + i, i, 0.1 * i)), TransformFault::kNone);
  }
  EXPECT_EQ(tree.add_static(transform("/base", "/laser", 0.0, 0.5, kQuarterTurn)),
            TransformFault::kNone);
  return tree;
}

TEST(TransformTree, AChainOfStillAndMovingTransforms) {
  const TransformTree tree = robot();
  const auto still = tree.look_up("base", "laser", at(99.0));
  ASSERT_TRUE(still.is_found());
  EXPECT_TRUE(still.is_static);
  EXPECT_NEAR(still.T_target_source.translation().x(), 0.5, 1e-12);
  EXPECT_NEAR(yaw_rad(still.T_target_source), kQuarterTurn, 1e-12);
  const auto moving = tree.look_up("odom", "/laser", at(10.0));
  ASSERT_TRUE(moving.is_found());
  EXPECT_FALSE(moving.is_static);
  EXPECT_NEAR(moving.T_target_source.translation().x(), 0.5, 1e-12);
}

TEST(TransformTree, MovingTransformsAreInterpolated) {
  const TransformTree tree = robot();
  for (const double t : {10.0, 10.25, 13.5, 19.999, 20.0}) {
    const auto lookup = tree.look_up("odom", "base", at(t));
    ASSERT_TRUE(lookup.is_found()) << lookup.reason;
    EXPECT_NEAR(lookup.T_target_source.translation().x(), t - 10.0, 1e-9);
    EXPECT_NEAR(yaw_rad(lookup.T_target_source), 0.1 * (t - 10.0), 1e-9);
  }
}

TEST(TransformTree, TheOtherWayRoundIsTheInverse) {
  const TransformTree tree = robot();
  const auto there = tree.look_up("odom", "laser", at(13.3));
  const auto back = tree.look_up("laser", "odom", at(13.3));
  EXPECT_TRUE(
      (there.T_target_source * back.T_target_source).isApprox(Eigen::Isometry3d::Identity()));
}

TEST(TransformTree, OfTwoBranchesOnlyTheirOwnPartsMustBeKnown) {
  TransformTree tree = robot();
  tree.add_static(transform("base", "imu", 0.0, -0.25));
  const auto lookup = tree.look_up("imu", "laser", at(999.0));  // odom -> base is long over.
  ASSERT_TRUE(lookup.is_found());
  EXPECT_TRUE(lookup.is_static);
  EXPECT_NEAR(lookup.T_target_source.translation().x(), 0.75, 1e-12);
}

TEST(TransformTree, OutsideOfTheTimeKnownTheNearestIsTakenWithinALimit) {
  const TransformTree tree = robot();
  const auto late = tree.look_up("odom", "laser", at(20.3));
  EXPECT_EQ(late.status, LookupStatus::kOutsideOfTime);
  EXPECT_NEAR(late.outside_s, 0.3, 1e-9);
  EXPECT_THAT(late.reason,
              HasSubstr("no transform from odom to laser: where base is in odom is known from "
                        "10.000000 to 20.000000, not at 20.300000"));
  EXPECT_NEAR(tree.look_up("odom", "laser", at(9.8)).outside_s, -0.2, 1e-9);
  const auto near = tree.look_up("odom", "base", at(20.3), 0.5);
  ASSERT_TRUE(near.is_found());
  EXPECT_NEAR(near.outside_s, 0.3, 1e-9);
  EXPECT_NEAR(near.T_target_source.translation().x(), 10.0, 1e-9);
}

TEST(TransformTree, MissingLinksAreToldByReason) {
  TransformTree tree = robot();
  tree.add_static(transform("world", "camera"));
  const auto unknown = tree.look_up("base", "scanner", at(10.0));
  EXPECT_EQ(unknown.status, LookupStatus::kUnknownFrame);
  EXPECT_EQ(unknown.reason, "no transform from base to scanner: scanner is not in any transform");
  const auto apart = tree.look_up("base", "camera", at(10.0));
  EXPECT_EQ(apart.status, LookupStatus::kNotConnected);
  EXPECT_THAT(apart.reason, HasSubstr("one hangs from odom, the other from world"));
  EXPECT_TRUE(tree.look_up("nowhere", "nowhere", at(10.0)).is_found());
}

TEST(TransformTree, AFrameHangsFromItsParent) {
  const TransformTree tree = robot();
  EXPECT_EQ(tree.parent_of("laser"), "base");
  EXPECT_EQ(tree.parent_of("base"), "odom");
  EXPECT_EQ(tree.parent_of("odom"), "");
  EXPECT_EQ(tree.parent_of("nowhere"), "");
}

TEST(TransformTree, LoopsEnd) {
  TransformTree tree;
  tree.add_static(transform("a", "b"));
  tree.add_static(transform("b", "c"));
  tree.add_static(transform("c", "a"));
  EXPECT_EQ(tree.look_up("a", "c", at(0.0)).status, LookupStatus::kLoop);
  EXPECT_EQ(tree.add_static(transform("a", "a")), TransformFault::kNoFrame);
}

TEST(TransformTree, BadTransformsAreRefusedAndNamed) {
  TransformTree tree;
  EXPECT_EQ(tree.add(transform("a", "")), TransformFault::kNoFrame);
  EXPECT_EQ(tree.add(transform("/", "b")), TransformFault::kNoFrame);
  TransformStamped bad = transform("a", "b");
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    bad.translation_m = Eigen::Vector3d(1.0, 2.0, 3.0);
    bad.translation_m[axis] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(tree.add(bad), TransformFault::kNotFinite);
  }
  bad = transform("a", "b");
  bad.rotation.coeffs().setZero();
  EXPECT_EQ(tree.add(bad), TransformFault::kNoRotation);
  EXPECT_THAT(tree.links(), SizeIs(0));
  bad.rotation.coeffs() << 0.0, 0.0, 0.0, 2.0;
  EXPECT_EQ(tree.add(bad), TransformFault::kBadRotation);
  bad.rotation.coeffs() << 0.0, 0.0, 0.0, 1.0;
  bad.translation_m.x() = 1e30;
  EXPECT_EQ(tree.add(bad), TransformFault::kNotFinite);
  EXPECT_THAT(tree.links(), SizeIs(0));
  bad.translation_m.x() = 0.0;
  bad.rotation.coeffs() << 0.0, 0.0, 0.0, 1.05;
  EXPECT_EQ(tree.add(bad), TransformFault::kNotNormalised);
  EXPECT_TRUE(
      tree.look_up("a", "b", at(0.0)).T_target_source.isApprox(Eigen::Isometry3d::Identity()));
  EXPECT_EQ(tree.add(transform("c", "b")), TransformFault::kParentChanged);
  EXPECT_EQ(tree.look_up("a", "b", at(0.0)).status, LookupStatus::kUnknownFrame);
}

TEST(TransformTree, MemoryIsBounded) {
  TransformTree tree;
  for (int i = 0; i < 5000; ++i) tree.add(transform("odom", "base", 1e-3 * i, i));
  EXPECT_EQ(tree.look_up("odom", "base", at(1.0)).status, LookupStatus::kOutsideOfTime);
  EXPECT_TRUE(tree.look_up("odom", "base", at(4.5)).is_found());
  tree.add(transform("odom", "base", 100.0));
  EXPECT_EQ(tree.look_up("odom", "base", at(4.5)).status, LookupStatus::kOutsideOfTime);
  for (int i = 1; i < 500; ++i) {
    EXPECT_EQ(tree.add(transform("a", "f" + std::to_string(i))), TransformFault::kNone);
  }
  tree.hold("a", "f1");
  EXPECT_EQ(tree.add(transform("a", "one more")), TransformFault::kTooManyFrames);
  EXPECT_THAT(tree.links(), SizeIs(TransformTree::kMaxFrames));
  EXPECT_EQ(tree.parent_of("one more"), "a");
  EXPECT_EQ(tree.parent_of("f1"), "a");  // Held: the oldest of the others is forgotten.
  EXPECT_EQ(tree.parent_of("base"), "");
}

TEST(TransformTree, WhatIsHeldStaysWhereItIs) {
  TransformTree tree;
  tree.add_static(transform("base", "mast", 0.0, 1.0));
  tree.add(transform("mast", "laser", 10.0, 2.0));
  tree.add_static(transform("base", "camera", 0.0, 3.0));
  tree.hold("base", "laser");
  EXPECT_EQ(tree.add_static(transform("base", "mast", 0.0, 1.0)), TransformFault::kNone);
  EXPECT_EQ(tree.add_static(transform("base", "mast", 0.0, 1.5)), TransformFault::kContradicts);
  EXPECT_EQ(tree.add(transform("base", "mast", 10.0, 1.5)), TransformFault::kContradicts);
  EXPECT_EQ(tree.add_static(transform("odom", "mast", 0.0, 1.0)), TransformFault::kContradicts);
  EXPECT_EQ(tree.add_static(transform("mast", "laser", 0.0, 2.0)), TransformFault::kNone);
  EXPECT_EQ(tree.add_static(transform("mast", "laser", 0.0, 5.0)), TransformFault::kContradicts);
  EXPECT_EQ(tree.add(transform("mast", "laser", 10.1, 2.5)), TransformFault::kNone);  // It moves.
  EXPECT_EQ(tree.add_static(transform("base", "camera", 0.0, 4.0)), TransformFault::kNone);
  EXPECT_NEAR(tree.look_up("base", "laser", at(10.0)).T_target_source.translation().x(), 3.0, 1e-9);
  EXPECT_NEAR(
      tree.look_up("base", "camera", at(10.0)).T_target_source.translation().x(), 4.0, 1e-9);
}

TEST(TransformTree, StampsOutOfOrderAreSortedAndAClockSetBackBeginsAnew) {
  TransformTree tree;
  for (const double t : {10.0, 12.0, 11.0, 11.0, 13.0}) tree.add(transform("o", "b", t, 2.0 * t));
  EXPECT_NEAR(tree.look_up("o", "b", at(11.5)).T_target_source.translation().x(), 23.0, 1e-9);
  tree.add(transform("o", "b", 1e9, 7.0));  // One wrong stamp, far ahead.
  tree.add(transform("o", "b", 14.0, 28.0));
  EXPECT_NEAR(tree.look_up("o", "b", at(14.0)).T_target_source.translation().x(), 28.0, 1e-9);
}

TEST(TransformTree, ChainsComposeAsTheirLinksDo) {
  auto generator = testing::make_generator();
  TransformTree tree;
  Eigen::Isometry3d product = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 20; ++i) {
    TransformStamped link = transform("f" + std::to_string(i), "f" + std::to_string(i + 1), 1.0);
    for (int k = 0; k < 3; ++k) link.translation_m[k] = testing::uniform(generator, -2.0, 2.0);
    for (int k = 0; k < 4; ++k) {
      link.rotation.coeffs()[k] = testing::uniform(generator, -1.0, 1.0);
    }
    link.rotation.normalize();
    product = product * Eigen::Translation3d(link.translation_m) * link.rotation;
    i % 2 == 0 ? tree.add(link) : tree.add_static(link);
  }
  const auto lookup = tree.look_up("f0", "f20", at(1.0));
  EXPECT_TRUE(lookup.T_target_source.isApprox(product, 1e-9)) << testing::test_seed();
}

}  // namespace setsquare::transform_tree_test
