// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/message_decoder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "setsquare/io/ros/builtin_definitions.hpp"
#include "tests/io/ros_golden_bytes.hpp"

namespace setsquare::message_decoder_test {

using ros::MessageDecoder;
using testing::bytes_from_hex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const Timestamp kStamp{1'700'000'000'123'456'789};
const Eigen::Vector3d kPosition(1.5, -2.5, 0.25);
const Eigen::Quaterniond kRotation(0.9, 0.1, 0.2, 0.3);
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Decodes a message with the well-known definition, and sees that each shorter one is refused.
template <typename MessageType>
MessageType decode(const std::string& type, const std::string& bytes, MessageEncoding encoding) {
  MessageDecoder<MessageType> decoder({"/topic", type, "", encoding});
  EXPECT_THAT(decoder.fault(), IsEmpty());
  MessageType message;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_NE(decoder.decode(bytes.substr(0, size), message), "") << type << " cut at " << size;
  }
  EXPECT_EQ(decoder.decode(bytes, message), "") << type;
  return message;
}

template <typename MessageType, typename Check>
void check_both(const std::string& type,
                std::string_view ros1,
                std::string_view cdr,
                const Check& check) {
  const std::string ros1_bytes = bytes_from_hex(ros1);
  check(decode<MessageType>(type, ros1_bytes, MessageEncoding::kRos1));
  const std::string cdr_bytes = bytes_from_hex(cdr);
  check(decode<MessageType>(type, cdr_bytes, MessageEncoding::kCdr));
}

template <typename MessageType>
void expect_header(const MessageType& message, const std::string& frame) {
  EXPECT_EQ(message.stamp, kStamp);
  EXPECT_EQ(message.frame_id, frame);
}

template <typename Scan>
void expect_sweep(const Scan& scan) {
  expect_header(scan, "laser");
  EXPECT_EQ(scan.angle_min_rad, -1.5);
  EXPECT_EQ(scan.angle_max_rad, 1.5);
  EXPECT_EQ(scan.angle_increment_rad, 1.5);
  EXPECT_EQ(scan.time_increment_s, 0.25);
  EXPECT_EQ(scan.scan_time_s, 0.75);
  EXPECT_EQ(scan.range_min_m, 0.125);
  EXPECT_EQ(scan.range_max_m, 30.0);
}

TEST(MessageDecoder, LaserScan) {
  const auto check = [](const ros::LaserScan& scan) {
    expect_sweep(scan);
    EXPECT_THAT(scan.ranges_m, ElementsAre(1.5, 2.5, kInfinity));
  };
  check_both<ros::LaserScan>(
      "sensor_msgs/LaserScan", testing::kRos1LaserScan, testing::kCdrLaserScan, check);
  check(decode<ros::LaserScan>("sensor_msgs/LaserScan",
                               bytes_from_hex(testing::kBigEndianCdrLaserScan),
                               MessageEncoding::kCdr));
}

TEST(MessageDecoder, MultiEchoLaserScan) {
  const auto check = [](const ros::MultiEchoLaserScan& scan) {
    expect_sweep(scan);
    ASSERT_THAT(scan.echoes_m, SizeIs(3));
    ASSERT_THAT(scan.intensities, SizeIs(3));
    std::vector<double> values;
    scan.echoes_m[0].copy_to(values);
    EXPECT_THAT(values, ElementsAre(1.5, 2.5));
    scan.intensities[2].copy_to(values);
    EXPECT_THAT(values, ElementsAre(30.0));
    EXPECT_EQ(scan.echoes_m[1].size(), 0U);
  };
  check_both<ros::MultiEchoLaserScan>("sensor_msgs/MultiEchoLaserScan",
                                      testing::kRos1MultiEchoLaserScan,
                                      testing::kCdrMultiEchoLaserScan,
                                      check);
}

TEST(MessageDecoder, PointCloud2) {
  const auto check = [](const ros::PointCloud2& points) {
    expect_header(points, "lidar");
    EXPECT_EQ(points.height, 1U);
    EXPECT_EQ(points.width, 2U);
    EXPECT_FALSE(points.is_bigendian);
    EXPECT_EQ(points.point_step_bytes, 14U);
    EXPECT_EQ(points.row_step_bytes, 28U);
    EXPECT_EQ(points.data.size(), 28U);
    ASSERT_THAT(points.fields, SizeIs(4));
    EXPECT_EQ(points.fields[3].name, "ring");
    EXPECT_EQ(points.fields[3].offset_bytes, 12U);
    EXPECT_EQ(points.fields[3].datatype, 4U);
    EXPECT_EQ(points.fields[3].count, 1U);
  };
  check_both<ros::PointCloud2>(
      "sensor_msgs/PointCloud2", testing::kRos1PointCloud2, testing::kCdrPointCloud2, check);
}

TEST(MessageDecoder, Odometry) {
  const auto check = [](const ros::Odometry& odometry) {
    expect_header(odometry, "odom");
    EXPECT_EQ(odometry.child_frame_id, "base");
    EXPECT_EQ(odometry.position_m, kPosition);
    EXPECT_EQ(odometry.orientation.coeffs(), kRotation.coeffs());
    EXPECT_EQ(odometry.velocity_m_per_s, Eigen::Vector3d(0.5, 0.0, 0.0));
    EXPECT_EQ(odometry.turn_rate_rad_per_s, Eigen::Vector3d(0.0, 0.0, -0.25));
  };
  check_both<ros::Odometry>(
      "nav_msgs/Odometry", testing::kRos1Odometry, testing::kCdrOdometry, check);
}

TEST(MessageDecoder, Imu) {
  const auto check = [](const ros::Imu& imu) {
    expect_header(imu, "imu");
    EXPECT_EQ(imu.orientation.coeffs(), kRotation.coeffs());
    EXPECT_FALSE(imu.has_orientation());
    EXPECT_TRUE(imu.has_turn_rate());
    EXPECT_EQ(imu.turn_rate_rad_per_s, Eigen::Vector3d(0.5, 0.25, -0.125));
    EXPECT_THAT(imu.turn_rate_covariance, ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9));
    EXPECT_EQ(imu.acceleration_m_per_s2, Eigen::Vector3d(0.0, 0.0, 9.75));
  };
  check_both<ros::Imu>("sensor_msgs/Imu", testing::kRos1Imu, testing::kCdrImu, check);
}

TEST(MessageDecoder, TransformsOfBothNames) {
  const auto check = [](const ros::TfMessage& message) {
    ASSERT_THAT(message.transforms, SizeIs(2));
    expect_header(message.transforms[0], "odom");
    EXPECT_EQ(message.transforms[0].child_frame_id, "base");
    EXPECT_EQ(message.transforms[0].translation_m, kPosition);
    EXPECT_EQ(message.transforms[0].rotation.coeffs(), kRotation.coeffs());
    expect_header(message.transforms[1], "base");
    EXPECT_EQ(message.transforms[1].child_frame_id, "laser");
    EXPECT_EQ(message.transforms[1].translation_m, Eigen::Vector3d(4.0, 5.0, 6.0));
  };
  for (const char* type : {"tf2_msgs/TFMessage", "tf/tfMessage", "tf2_msgs/msg/TFMessage"}) {
    check_both<ros::TfMessage>(type, testing::kRos1TFMessage, testing::kCdrTFMessage, check);
  }
}

TEST(MessageDecoder, StampedPoses) {
  const auto check = [](const ros::PoseStamped& pose) {
    expect_header(pose, "map");
    EXPECT_EQ(pose.position_m, kPosition);
    EXPECT_EQ(pose.orientation.coeffs(), kRotation.coeffs());
  };
  check_both<ros::PoseStamped>(
      "geometry_msgs/PoseStamped", testing::kRos1PoseStamped, testing::kCdrPoseStamped, check);
  check_both<ros::PoseWithCovarianceStamped>("geometry_msgs/PoseWithCovarianceStamped",
                                             testing::kRos1PoseWithCovarianceStamped,
                                             testing::kCdrPoseWithCovarianceStamped,
                                             check);
}

TEST(MessageDecoder, PathAndOccupancyGrid) {
  const auto path =
      decode<ros::Path>("nav_msgs/Path", bytes_from_hex(testing::kCdrPath), MessageEncoding::kCdr);
  expect_header(path, "map");
  ASSERT_THAT(path.poses, SizeIs(2));
  EXPECT_EQ(path.poses[1].position_m, Eigen::Vector3d(4.0, 5.0, 6.0));
  const auto grid = decode<ros::OccupancyGrid>(
      "nav_msgs/OccupancyGrid", bytes_from_hex(testing::kCdrOccupancyGrid), MessageEncoding::kCdr);
  expect_header(grid, "map");
  EXPECT_EQ(grid.resolution_m, 0.5);
  EXPECT_EQ(grid.width, 3U);
  EXPECT_EQ(grid.height, 2U);
  EXPECT_EQ(grid.origin_m, kPosition);
  EXPECT_EQ(grid.origin_orientation.coeffs(), kRotation.coeffs());
  EXPECT_THAT(grid.cells, ElementsAre(0, 100, -1, 50, 1, 2));
}

TEST(MessageDecoder, TheRecordingsOwnDefinitionWins) {
  // Ranges first, as float64; a field that no LaserScan has.
  const std::string line = std::string(80, '=') + "\nMSG: ";
  const std::string definition =
      "float64[] ranges\nHeader header\nfloat32 angle_min\nfloat32 angle_max\nstring model\n"
      "float32 angle_increment\nfloat32 time_increment\nfloat32 scan_time\nfloat32 range_min\n"
      "float32 range_max\n" +
      line + "std_msgs/Header\nstring frame_id\ntime stamp\n";
  MessageDecoder<ros::LaserScan> decoder(
      {"/scan", "sensor_msgs/LaserScan", definition, MessageEncoding::kRos1});
  EXPECT_THAT(decoder.fault(), IsEmpty());
  EXPECT_THAT(decoder.remark(), IsEmpty());
  const std::string bytes = bytes_from_hex(
      "02000000"
      "000000000000f83f"
      "0000000000000440"
      "03000000"
      "616263"
      "01000000"
      "02000000"
      "0000803f"
      "0000803f"
      "01000000"
      "78"
      "0000003f"
      "0000003f"
      "0000003f"
      "0000003f"
      "00002041");
  ros::LaserScan scan;
  ASSERT_EQ(decoder.decode(bytes, scan), "");
  EXPECT_THAT(scan.ranges_m, ElementsAre(1.5, 2.5));
  EXPECT_EQ(scan.frame_id, "abc");
  EXPECT_EQ(scan.stamp, Timestamp{1'000'000'002});
  EXPECT_EQ(scan.angle_increment_rad, 0.5);
  EXPECT_EQ(scan.range_max_m, 10.0);
}

TEST(MessageDecoder, ADefinitionThatCannotBeReadIsReplacedByTheWellKnownOne) {
  MessageDecoder<ros::LaserScan> decoder(
      {"/scan", "sensor_msgs/msg/LaserScan", "module sensor_msgs {\n};\n", MessageEncoding::kCdr});
  EXPECT_THAT(decoder.fault(), IsEmpty());
  EXPECT_THAT(decoder.remark(), HasSubstr("IDL"));
  ros::LaserScan scan;
  EXPECT_EQ(decoder.decode(bytes_from_hex(testing::kCdrLaserScan), scan), "");
}

TEST(MessageDecoder, WhatCannotBeDecodedSaysWhy) {
  const MessageDecoder<ros::LaserScan> lacking(
      {"/scan", "sensor_msgs/LaserScan", "float32 angle_min\n", MessageEncoding::kCdr});
  EXPECT_THAT(lacking.fault(), HasSubstr("sensor_msgs/LaserScan has no field header.stamp"));
  MessageDecoder<ros::LaserScan> unknown({"/scan", "my_msgs/Scan", "", MessageEncoding::kCdr});
  EXPECT_THAT(unknown.fault(), HasSubstr("no definition of my_msgs/Scan"));
  ros::LaserScan scan;
  EXPECT_EQ(unknown.decode("", scan), unknown.fault());
}

TEST(MessageDecoder, AHeaderThatIsASequenceIsNoHeader) {
  std::string definition = ros::builtin_definition("sensor_msgs/LaserScan", MessageEncoding::kRos1);
  definition.replace(definition.find("std_msgs/Header header"), 22, "std_msgs/Header[] header");
  MessageDecoder<ros::LaserScan> decoder(
      {"/scan", "sensor_msgs/LaserScan", definition, MessageEncoding::kRos1});
  ros::LaserScan scan;
  EXPECT_THAT(std::string(decoder.decode(std::string(100, '\0'), scan)), HasSubstr("too few"));
}

TEST(MessageDecoder, StampsOfZeroStayAndNanosecondsCarryOver) {
  const std::string message = bytes_from_hex(testing::kRos1PoseStamped);
  MessageDecoder<ros::PoseStamped> decoder(
      {"/pose", "geometry_msgs/PoseStamped", "", MessageEncoding::kRos1});
  const auto stamp_of = [&](const std::string& stamp_hex) {
    std::string changed = message;
    changed.replace(4, 8, bytes_from_hex(stamp_hex));
    ros::PoseStamped pose;
    EXPECT_EQ(decoder.decode(changed, pose), "");
    return pose.stamp.ns;
  };
  EXPECT_EQ(stamp_of("0000000000000000"), 0);
  EXPECT_EQ(stamp_of("01000000ffffffff"), 1'000'000'000 + 4'294'967'295);
  EXPECT_EQ(stamp_of("ffffffff00000000"), 4'294'967'295'000'000'000);
}

}  // namespace setsquare::message_decoder_test
