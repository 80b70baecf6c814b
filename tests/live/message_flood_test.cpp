// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A robot beside a node that is broken, or lies: damaged and hostile messages of every kind that
// live mapping hears, a thousand of each, between those of a drive. The map is that of the drive
// alone, and what was left out is told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "setsquare/io/logs/bag/live_log.hpp"
#include "setsquare/io/logs/bag/ros_log_writer.hpp"
#include "setsquare/io/logs/bag/scan_messages.hpp"
#include "setsquare/io/ros/message_encoder.hpp"
#include "setsquare/live/mapping_session.hpp"
#include "setsquare/live/message_queue.hpp"
#include "tests/live/room_log.hpp"
#include "tests/support/seed.hpp"

namespace setsquare {
namespace message_flood_test {

using live_test::RoomLog;
using ::testing::Contains;
using ::testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr Timestamp kBegin{1'700'000'000 * kSecond_ns};
/// Of the drive, before anybody lies.
constexpr std::size_t kNumHonest = 60;
constexpr int kNumOfEach = 1000;

Timestamp later(Timestamp stamp, std::int64_t seconds) { return {stamp.ns + seconds * kSecond_ns}; }

/// Topics of a robot, whose messages go into a queue as they come.
class Robot final : public MessageSink {
 public:
  explicit Robot(MessageQueue& queue) : queue_(queue) {
    for (const auto& [name, type] :
         std::map<std::string, std::string>{{"/scan", "sensor_msgs/LaserScan"},
                                            {"/odom", "nav_msgs/Odometry"},
                                            {"/tf", "tf2_msgs/TFMessage"},
                                            {"/tf_static", "tf2_msgs/TFMessage"}}) {
      topics_[name] = queue.add(
          {.name = name, .type = type, .definition = {}, .encoding = MessageEncoding::kCdr});
    }
  }

  [[nodiscard]] Channel add_channel(const std::string& topic,
                                    const std::string& /*type*/,
                                    bool /*is_latched*/) override {
    return topics_.at(topic);
  }
  void write(Channel channel, Timestamp stamp, std::string_view cdr) override {
    // One at a time: a queue that overflows is another test.
    while (queue_.num_waiting() > 100) std::this_thread::yield();
    queue_.push(channel, stamp, cdr);
  }
  template <typename Message>
  void say(const std::string& topic, const Message& message, Timestamp now) {
    write(topics_.at(topic), now, bytes_of(message));
  }
  void say_bytes(const std::string& topic, const std::string& bytes, Timestamp now) {
    write(topics_.at(topic), now, bytes);
  }
  template <typename Message>
  [[nodiscard]] std::string bytes_of(const Message& message) {
    ros::encode(message, writer_);
    return writer_.message();
  }

 private:
  MessageQueue& queue_;
  std::map<std::string, std::size_t> topics_;
  ros::CdrWriter writer_;
};

/// The node that lies. Each of its messages is to be left out.
class Liar {
 public:
  Liar(Robot& robot, const Scan& scan) : robot_(robot) {
    laser_scan_from_scan(scan, "laser", scan_);
  }

  /// One message of each kind, while the robot is somewhere.
  void lie(Timestamp now, const Pose2& T_odom_base) {
    lie_about_scan(now);
    lie_about_odometry(now, T_odom_base);
    lie_about_frames(now, T_odom_base);
    lie_about_mounting(now);
  }

 private:
  using Random = std::mt19937_64;

  [[nodiscard]] double absurd() {
    constexpr std::array<double, 6> kNumbers = {kNan, kInfinity, -kInfinity, 1e30, -1e300, 1e9};
    return kNumbers[random_() % kNumbers.size()];
  }
  /// Years ahead or back, or some seconds back.
  [[nodiscard]] Timestamp wrong_time(Timestamp now) {
    constexpr std::array<std::int64_t, 5> kOff_s = {300'000'000, -300'000'000, 3600, -20, -2};
    return later(now, kOff_s[random_() % kOff_s.size()]);
  }
  [[nodiscard]] std::string cut(std::string bytes) {
    bytes.resize(random_() % (bytes.size() - 8));
    return bytes;
  }

  void lie_about_scan(Timestamp now) {
    ros::LaserScan scan = scan_;
    scan.stamp = now;
    switch (random_() % 6) {
      case 0:
        return robot_.say_bytes("/scan", cut(robot_.bytes_of(scan)), now);
      case 1:
        scan.angle_min_rad = absurd();
        break;
      case 2:
        scan.angle_increment_rad = 1e5;
        break;
      case 3:
        scan.ranges_m.clear();
        break;
      case 4:
        scan.frame_id = "elsewhere_" + std::to_string(random_() % 50);
        break;
      default:
        scan.stamp = wrong_time(now);
    }
    robot_.say("/scan", scan, now);
  }

  void lie_about_odometry(Timestamp now, const Pose2& T_odom_base) {
    ros::Odometry odometry;
    odometry.stamp = now;
    odometry.frame_id = "odom";
    odometry.child_frame_id = "base_link";
    odometry.position_m = {T_odom_base.x_m, T_odom_base.y_m, 0.0};
    odometry.orientation = quaternion_from_yaw(T_odom_base.theta_rad);
    switch (random_() % 7) {
      case 0:
        return robot_.say_bytes("/odom", cut(robot_.bytes_of(odometry)), now);
      case 1:
        odometry.position_m[static_cast<Eigen::Index>(random_() % 2)] = absurd();
        break;
      case 2:
        odometry.orientation.coeffs().setConstant(random_() % 2 == 0 ? 0.0 : 3.0);
        break;
      case 3:
        odometry.child_frame_id = "laser";
        break;
      case 4:
        odometry.frame_id = "map";
        break;
      case 5:
        odometry.stamp = wrong_time(now);
        break;
      default:  // A second robot.
        odometry.position_m += Eigen::Vector3d(8.0, -6.0, 0.0);
    }
    robot_.say("/odom", odometry, now);
  }

  void lie_about_frames(Timestamp now, const Pose2& T_odom_base) {
    ros::TransformStamped frame = transform_from_pose(now, "odom", "base_link", T_odom_base);
    switch (random_() % 7) {
      case 0:
        return robot_.say_bytes("/tf", cut(robot_.bytes_of(ros::TfMessage{{frame}})), now);
      case 1:
        frame.translation_m.x() = absurd();
        break;
      case 2:
        frame.rotation.coeffs().setConstant(random_() % 2 == 0 ? 0.0 : 3.0);
        break;
      case 3:
        frame.stamp = wrong_time(now);
        break;
      case 4:
        frame.translation_m.x() += 5.0;
        break;
      case 5:
        frame = transform_from_pose(now, "odom", "laser", T_odom_base);
        break;
      default:
        frame = transform_from_pose(now, "base_link", "laser", {3.0, 1.0, 2.0});
    }
    robot_.say("/tf", ros::TfMessage{{frame}}, now);
  }

  void lie_about_mounting(Timestamp now) {
    ros::TransformStamped frame = transform_from_pose(now, "base_link", "laser", {0.3, 0.0, 1.0});
    switch (random_() % 5) {
      case 0:
        return robot_.say_bytes("/tf_static", cut(robot_.bytes_of(ros::TfMessage{{frame}})), now);
      case 1:
        frame.translation_m.y() = absurd();
        break;
      case 2:
        frame.rotation.coeffs().setConstant(random_() % 2 == 0 ? 0.0 : 3.0);
        break;
      case 3:
        frame.frame_id = "odom";
        break;
      default:
        break;
    }
    robot_.say("/tf_static", ros::TfMessage{{frame}}, now);
  }

  Robot& robot_;
  ros::LaserScan scan_;
  Random random_ = testing::make_generator();
};

struct Heard {
  MappedLog mapped;
  std::uint64_t num_left_out = 0;
};

/// The drive around the room, with messages between its scans from kNumHonest on.
Heard heard_drive(int num_lies_of_each) {
  auto made = std::make_unique<MessageQueue>("test");
  MessageQueue& queue = *made;
  Robot robot(queue);
  LogOptions options;
  options.sensor = "/scan";
  options.odometry_topic = "/odom";
  const auto log = open_live_log(std::move(made), "test", options);
  std::thread driver([&] {
    RoomLog room;
    RosLogWriter writer(robot);
    const std::size_t num_scans = room.num_scans();
    const auto num_after = static_cast<int>(num_scans - kNumHonest);
    std::unique_ptr<Liar> liar;
    for (std::size_t k = 0; k < num_scans; ++k) {
      LogRecord record = *room.next();
      record.sensor = "/scan";
      record.scan.T_base_sensor = {0.1, 0.0, 0.2};
      record.T_odom_base = *record.T_odom_base * record.scan.T_base_sensor.inverse();
      record.stamp = record.scan.stamp = {kBegin.ns + record.stamp.ns};
      writer.write(record);
      if (k < kNumHonest) continue;
      if (!liar) liar = std::make_unique<Liar>(robot, record.scan);
      const int done = static_cast<int>(k - kNumHonest);
      const int num_now =
          num_lies_of_each * (done + 1) / num_after - num_lies_of_each * done / num_after;
      for (int i = 0; i < num_now; ++i) {
        liar->lie({record.stamp.ns + (i + 1) * kSecond_ns / 1000}, *record.T_odom_base);
      }
    }
    queue.close();
  });
  MapLogOptions mapping;
  mapping.log = options;
  mapping.is_audited = false;
  Heard heard;
  MappingSession session("test", mapping, {}, {});
  heard.mapped = session.run(*log);
  driver.join();
  heard.num_left_out = queue.num_left_out();
  return heard;
}

TEST(MessageFlood, TheMapIsWhatItIsWithoutAndEachMessageIsCounted) {
  SCOPED_TRACE(testing::test_seed());
  const Heard alone = heard_drive(0);
  const Heard flooded = heard_drive(kNumOfEach);
  EXPECT_EQ(alone.num_left_out, 0U);
  EXPECT_EQ(alone.mapped.problems.num_damaged, 0U);
  const std::vector<MappedScan>& scans = flooded.mapped.map.scans;
  ASSERT_EQ(scans.size(), alone.mapped.map.scans.size());
  for (std::size_t k = 0; k < scans.size(); ++k) {
    ASSERT_EQ(scans[k].T_map_base, alone.mapped.map.scans[k].T_map_base) << k;
  }
  constexpr std::uint64_t kNumLies = 4 * kNumOfEach;
  EXPECT_EQ(flooded.num_left_out, kNumLies);
  EXPECT_EQ(flooded.mapped.problems.num_damaged, kNumLies);
  for (const char* topic : {"/scan: ", "/odom: ", "/tf: ", "/tf_static: "}) {
    EXPECT_THAT(flooded.mapped.problems.remarks,
                Contains(HasSubstr(topic + std::to_string(kNumOfEach) + " left out")));
  }
}

}  // namespace message_flood_test
}  // namespace setsquare
