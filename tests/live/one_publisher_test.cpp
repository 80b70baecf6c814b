// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/one_publisher.hpp"

#include <gtest/gtest.h>

#include <string>

#include "setsquare/io/ros/message_encoder.hpp"

namespace setsquare {
namespace one_publisher_test {

using std::chrono::milliseconds;

std::string odometry_bytes(double x_m = 0.0) {
  ros::Odometry odometry;
  odometry.position_m.x() = x_m;
  ros::CdrWriter writer;
  ros::encode(odometry, writer);
  return writer.message();
}

class OnePublisherTest : public ::testing::Test {
 protected:
  [[nodiscard]] bool hears(std::uint64_t publisher, int at_ms, const std::string& data) {
    return odometry_.hears(publisher, data, OnePublisher::Clock::time_point(milliseconds(at_ms)));
  }
  [[nodiscard]] bool hears(std::uint64_t publisher, int at_ms) {
    return hears(publisher, at_ms, odometry_bytes());
  }

  OnePublisher odometry_{MessageTopic{.name = "/odom",
                                      .type = "nav_msgs/Odometry",
                                      .definition = {},
                                      .encoding = MessageEncoding::kCdr}};
};

TEST_F(OnePublisherTest, TheFirstIsHeardAsLongAsItSpeaks) {
  EXPECT_TRUE(hears(7, 10'000));
  EXPECT_FALSE(hears(8, 11'000));
  EXPECT_TRUE(hears(7, 11'500));
  EXPECT_FALSE(hears(8, 13'400));
  EXPECT_TRUE(hears(8, 13'600));
  EXPECT_FALSE(hears(7, 13'700));
  EXPECT_EQ(odometry_.num_of_others(), 3U);
}

TEST_F(OnePublisherTest, WhatCannotBeUsedTakesAndKeepsNothing) {
  for (const std::string& bad : {std::string("noise"), odometry_bytes(1e30)}) {
    EXPECT_TRUE(hears(9, 1'000, bad));  // To be counted.
  }
  EXPECT_TRUE(hears(7, 1'001));
  EXPECT_FALSE(hears(9, 1'002, "noise"));
  EXPECT_TRUE(hears(7, 2'900, "noise"));
  EXPECT_TRUE(hears(8, 3'100));  // 7 said nothing for 2 s.
}

}  // namespace one_publisher_test
}  // namespace setsquare
