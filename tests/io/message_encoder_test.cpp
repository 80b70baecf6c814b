// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/ros/message_encoder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "setsquare/io/ros/message_decoder.hpp"
#include "tests/io/ros_golden_bytes.hpp"

namespace setsquare::message_encoder_test {

using ros::CdrWriter;
using ros::MessageDecoder;
using testing::bytes_from_hex;
using ::testing::ElementsAre;

/// Decodes what another implementation wrote and writes it again: the same bytes.
template <typename MessageType>
void expect_same_bytes(const std::string& type, std::string_view hex) {
  const std::string bytes = bytes_from_hex(hex);
  MessageDecoder<MessageType> decoder({"/topic", type, "", MessageEncoding::kCdr});
  MessageType message;
  ASSERT_EQ(decoder.decode(bytes, message), "") << type;
  CdrWriter writer;
  writer.write_text("what the last message left");
  encode(message, writer);
  EXPECT_EQ(writer.message(), bytes) << type;
}

TEST(MessageEncoder, WritesWhatOthersWrite) {
  expect_same_bytes<ros::Odometry>("nav_msgs/Odometry", testing::kCdrOdometry);
  expect_same_bytes<ros::TfMessage>("tf2_msgs/TFMessage", testing::kCdrTFMessage);
  expect_same_bytes<ros::PoseStamped>("geometry_msgs/PoseStamped", testing::kCdrPoseStamped);
  expect_same_bytes<ros::Path>("nav_msgs/Path", testing::kCdrPath);
  expect_same_bytes<ros::OccupancyGrid>("nav_msgs/OccupancyGrid", testing::kCdrOccupancyGrid);
}

TEST(MessageEncoder, ScansAreWrittenWithoutIntensities) {
  const std::string bytes = bytes_from_hex(testing::kCdrLaserScan);
  MessageDecoder<ros::LaserScan> decoder(
      {"/scan", "sensor_msgs/LaserScan", "", MessageEncoding::kCdr});
  ros::LaserScan scan;
  ASSERT_EQ(decoder.decode(bytes, scan), "");
  CdrWriter writer;
  encode(scan, writer);
  constexpr std::size_t kIntensityBytes = 4 + 3 * 4;
  const std::string expected =
      bytes.substr(0, bytes.size() - kIntensityBytes) + std::string(4, '\0');
  EXPECT_EQ(writer.message(), expected);
}

TEST(MessageEncoder, TimesBeforeTheEpochAndNumbersTooLargeReadBack) {
  ros::LaserScan scan;
  scan.stamp = {-1};
  scan.ranges_m = {1e300, -1e300, 1.5};
  CdrWriter writer;
  encode(scan, writer);
  MessageDecoder<ros::LaserScan> decoder(
      {"/scan", "sensor_msgs/LaserScan", "", MessageEncoding::kCdr});
  ros::LaserScan back;
  ASSERT_EQ(decoder.decode(writer.message(), back), "");
  EXPECT_EQ(back.stamp, scan.stamp);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_THAT(back.ranges_m, ElementsAre(kInfinity, -kInfinity, 1.5));
}

}  // namespace setsquare::message_encoder_test
