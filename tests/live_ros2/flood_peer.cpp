// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A node that is broken, and lies: sends messages of every kind that live mapping hears, damaged
// ones and whole ones that are not true.
// flood_peer DOMAIN NUM_OF_EACH SEED
#include <array>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "setsquare/dds/participant.hpp"
#include "setsquare/io/logs/bag/scan_messages.hpp"
#include "setsquare/io/ros/message_encoder.hpp"

namespace {

using namespace setsquare;

template <typename Message>
std::string bytes_of(const Message& message) {
  ros::CdrWriter writer;
  ros::encode(message, writer);
  return writer.message();
}

struct Kind {
  std::string topic;
  std::string type;
  dds::TopicQos qos;
  std::string whole;
  std::shared_ptr<dds::Publisher> publisher = nullptr;
};

std::vector<Kind> kinds() {
  ros::LaserScan scan;
  scan.frame_id = "laser";
  scan.angle_increment_rad = 0.01;
  scan.range_max_m = 30.0;
  scan.ranges_m.assign(360, 2.0);
  ros::Odometry odometry;
  odometry.frame_id = "odom";
  odometry.child_frame_id = "base_link";
  odometry.position_m.x() = 7.0;
  const ros::TfMessage moved{{transform_from_pose({}, "odom", "base_link", {7.0, 1.0, 2.0})}};
  const ros::TfMessage fixed{{transform_from_pose({}, "base_link", "laser", {-0.5, 0.0, 3.0})}};
  ros::PoseWithCovarianceStamped said;
  said.frame_id = "map";
  said.position_m.x() = 1e5;
  return {{"/scan", "sensor_msgs/msg/LaserScan", dds::kSensorQos, bytes_of(scan)},
          {"/odom", "nav_msgs/msg/Odometry", dds::kTransformQos, bytes_of(odometry)},
          {"/tf", "tf2_msgs/msg/TFMessage", dds::kTransformQos, bytes_of(moved)},
          {"/tf_static", "tf2_msgs/msg/TFMessage", dds::kStaticTransformQos, bytes_of(fixed)},
          {"/initialpose",
           "geometry_msgs/msg/PoseWithCovarianceStamped",
           {.depth = 10},
           bytes_of(said)}};
}

/// Whole, cut short, or with bytes changed, or with a count of elements that no message has, or
/// noise.
std::string spoilt(const std::string& whole, std::mt19937_64& random) {
  std::string bytes = whole;
  switch (random() % 5) {
    case 4:
      break;
    case 0:
      bytes.resize(random() % bytes.size());
      break;
    case 1:
      for (int k = 0; k < 4; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
      break;
    case 2:
      for (std::size_t at = random() % bytes.size(), k = 0; k < 4 && at + k < bytes.size(); ++k) {
        bytes[at + k] = '\xff';
      }
      break;
    default:
      for (char& byte : bytes) byte = static_cast<char>(random());
  }
  return bytes;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const int num_of_each = std::atoi(argv[2]);
  std::mt19937_64 random(std::strtoull(argv[3], nullptr, 10));
  dds::Participant participant({.domain = std::atoi(argv[1]), .node_name = "flood"});
  std::vector<Kind> all = kinds();
  for (Kind& kind : all) kind.publisher = participant.advertise(kind.topic, kind.type, kind.qos);
  for (int i = 0; i < 400 && all.front().publisher->num_matched() == 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  if (all.front().publisher->num_matched() == 0) return 3;
  for (int i = 0; i < num_of_each; ++i) {
    for (const Kind& kind : all) kind.publisher->publish(spoilt(kind.whole, random));
    if (i % 4 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  std::cout << num_of_each << " of each\n";
  return 0;
}
