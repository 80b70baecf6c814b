// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/message_queue.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "setsquare/io/logs/bag/live_log.hpp"
#include "setsquare/io/logs/bag/scan_messages.hpp"
#include "setsquare/io/ros/message_encoder.hpp"
#include "tests/support/seed.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare {
namespace message_queue_test {

MessageTopic topic_of(const std::string& name, const std::string& type) {
  return {.name = name, .type = type, .definition = {}, .encoding = MessageEncoding::kCdr};
}

TEST(MessageQueue, GivesWhatCameInItsOrderAndThenTheEnd) {
  MessageQueue queue("test");
  const std::size_t topic = queue.add(topic_of("/scan", "sensor_msgs/LaserScan"));
  std::thread writer([&] {
    for (int i = 0; i < 1000; ++i) queue.push(topic, {i}, std::to_string(i));
    queue.close();
  });
  Message message;
  int num = 0;
  while (queue.read(message)) {
    EXPECT_EQ(message.data, std::to_string(num));
    EXPECT_EQ(message.log_time.ns, num);
    ++num;
  }
  writer.join();
  EXPECT_EQ(num, 1000);
  EXPECT_EQ(queue.num_dropped(), 0U);
}

TEST(MessageQueue, DropsTheOldestOfAFloodAndCountsThem) {
  MessageQueue queue("test");
  const std::size_t topic = queue.add(topic_of("/scan", "sensor_msgs/LaserScan"));
  constexpr int kNum = 10000;
  for (int i = 0; i < kNum; ++i) queue.push(topic, {i}, "x");
  Message message;
  ASSERT_TRUE(queue.read(message));
  EXPECT_EQ(message.log_time.ns, kNum - static_cast<int>(MessageQueue::kMaxMessages));
  EXPECT_EQ(queue.num_dropped(), kNum - MessageQueue::kMaxMessages);
}

TEST(MessageQueue, HoldsNoMoreThanItsBytes) {
  MessageQueue queue("test");
  const std::size_t topic = queue.add(topic_of("/scan", "sensor_msgs/LaserScan"));
  const std::string large(10U << 20U, 'x');
  for (int i = 0; i < 20; ++i) queue.push(topic, {i}, large);
  EXPECT_EQ(queue.num_dropped(), 20U - MessageQueue::kMaxBytes / large.size());
}

/// Every kind of message that is read, whole and then damaged at random: no crash, and what is left
/// is read on.
TEST(MessageQueue, DamagedMessagesAreCountedAndWhatIsWholeIsRead) {
  auto random = testing::make_generator();
  SCOPED_TRACE(testing::test_seed());
  constexpr int kNumOfEach = 1000;
  auto made = std::make_unique<MessageQueue>("test");
  MessageQueue& queue = *made;
  const std::size_t scans = queue.add(topic_of("/scan", "sensor_msgs/LaserScan"));
  const std::size_t odometry = queue.add(topic_of("/odom", "nav_msgs/Odometry"));
  const std::size_t transforms = queue.add(topic_of("/tf", "tf2_msgs/TFMessage"));
  const std::size_t fixed = queue.add(topic_of("/tf_static", "tf2_msgs/TFMessage"));
  LogOptions options;
  options.sensor = "/scan";
  options.odometry_topic = "/odom";
  const auto log = open_live_log(std::move(made), "test", options);

  int num_read = 0;
  std::thread reader([&] {
    while (log->next() != nullptr) ++num_read;
  });
  ros::CdrWriter writer;
  const auto push = [&](std::size_t topic, const auto& message, Timestamp stamp, bool is_damaged) {
    ros::encode(message, writer);
    std::string bytes = writer.message();
    if (is_damaged) {
      for (std::size_t k = 1 + random() % 8; k > 0; --k)
        bytes[random() % bytes.size()] ^= static_cast<char>(random());
      if (random() % 2 == 0) bytes.resize(random() % bytes.size());
    }
    // One at a time: a queue that overflows is another test.
    while (queue.num_waiting() > 100) std::this_thread::yield();
    queue.push(topic, stamp, bytes);
  };
  const ros::TfMessage mounting{{transform_from_pose({}, "base_link", "laser", {0.1, 0.0, 0.0})}};
  push(fixed, mounting, {}, false);
  ros::LaserScan scan;
  laser_scan_from_scan(
      testing::scan_of_walls(testing::l_shaped_room(), {1.0, 1.0, 0.0}), "laser", scan);
  for (int i = 0; i < kNumOfEach; ++i) {
    const Timestamp stamp{1'000'000'000LL * (i + 1) / 10};
    ros::Odometry pose;
    pose.stamp = stamp;
    pose.frame_id = "odom";
    pose.child_frame_id = "base_link";
    scan.stamp = stamp;
    const ros::TfMessage moved{{transform_from_pose(stamp, "odom", "base_link", {})}};
    for (const bool is_damaged : {true, false}) {
      push(fixed, mounting, stamp, is_damaged);
      push(transforms, moved, stamp, is_damaged);
      push(odometry, pose, stamp, is_damaged);
      push(scans, scan, stamp, is_damaged);
    }
  }
  queue.close();
  reader.join();
  EXPECT_GE(num_read, kNumOfEach * 9 / 10);
  EXPECT_GT(log->problems().num_damaged, 100U);
}

}  // namespace message_queue_test
}  // namespace setsquare
