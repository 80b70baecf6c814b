// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/one_publisher.hpp"

#include <cmath>
#include <type_traits>
#include <variant>

#include "setsquare/io/ros/transform_tree.hpp"

namespace setsquare {
namespace {

bool is_possible_message(const ros::LaserScan& scan) {
  return !scan.ranges_m.empty() && std::isfinite(scan.angle_min_rad);
}

bool is_possible_message(const ros::Odometry& odometry) {
  return !ros::is_refused(ros::fault_of_pose(odometry.position_m, odometry.orientation));
}

template <typename Message>
bool is_possible_message(const Message& /*message*/) {
  return true;
}

}  // namespace

bool OnePublisher::is_usable(std::string_view data) {
  return std::visit(
      [&](auto& topic) {
        if constexpr (std::is_same_v<std::decay_t<decltype(topic)>, std::monostate>) {
          return false;
        } else {
          return topic.decoder.decode(data, topic.message).empty() &&
                 is_possible_message(topic.message);
        }
      },
      *reader_.decoder);
}

bool OnePublisher::hears(std::uint64_t publisher, std::string_view data, Clock::time_point now) {
  const bool is_taken = publisher_ != 0 && now - last_ < kSilence;
  if (is_taken && publisher != publisher_) {
    ++num_of_others_;
    return false;
  }
  if (is_usable(data)) {
    publisher_ = publisher;
    last_ = now;
  }
  return true;
}

}  // namespace setsquare
