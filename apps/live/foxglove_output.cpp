// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/live/foxglove_output.hpp"

#include <utility>
#include <vector>

#include "apps/live/closure_lines.hpp"
#include "setsquare/io/logs/bag/scan_messages.hpp"
#include "setsquare/io/ros/builtin_definitions.hpp"
#include "setsquare/io/ros/message_encoder.hpp"

namespace setsquare::live_app {
namespace {

constexpr const char* kMarkers = "visualization_msgs/msg/MarkerArray";

/// A red cross, 1 m wide, where the map may be wrong.
std::vector<ClosureLine> crosses_of_doubts(const Map& map) {
  std::vector<ClosureLine> lines;
  for (const MapDoubt& doubt : map.doubts) {
    for (const Eigen::Vector2d& arm : {Eigen::Vector2d(0.5, 0.5), Eigen::Vector2d(0.5, -0.5)}) {
      lines.push_back({doubt.place_m - arm, doubt.place_m + arm, false});
    }
  }
  return lines;
}

}  // namespace

FoxgloveOutput::FoxgloveOutput(foxglove::Server& server, FrameNames frames)
    : server_(server), frames_(std::move(frames)) {
  transforms_ = add_channel("/tf", "tf2_msgs/msg/TFMessage", false);
  pose_ = add_channel("/pose", "geometry_msgs/msg/PoseWithCovarianceStamped", false);
  map_ = add_channel("/map", "nav_msgs/msg/OccupancyGrid", true);
  path_ = add_channel("/path", "nav_msgs/msg/Path", true);
  closures_ = server_.add_channel("/closures", kMarkers, closure_marker_definition(), true);
  doubts_ = server_.add_channel("/doubts", kMarkers, closure_marker_definition(), true);
}

std::uint32_t FoxgloveOutput::add_channel(const std::string& topic,
                                          const std::string& type,
                                          bool is_latched) {
  return server_.add_channel(topic,
                             type,
                             ros::builtin_definition(plain_type_name(type), MessageEncoding::kCdr),
                             is_latched);
}

FoxgloveOutput::Laser& FoxgloveOutput::laser_of(const std::string& sensor) {
  const auto [entry, is_new] = lasers_.try_emplace(sensor);
  if (is_new) {
    const std::string topic = laser_topic_name(sensor, lasers_.size() == 1);
    entry->second.frame = laser_frame_name(topic);
    entry->second.channel = add_channel(topic, "sensor_msgs/msg/LaserScan", false);
  }
  return entry->second;
}

template <typename Message>
void FoxgloveOutput::publish(std::uint32_t channel, Timestamp stamp, const Message& message) {
  ros::CdrWriter writer;
  ros::encode(message, writer);
  server_.publish(channel, stamp, writer.message());
}

void FoxgloveOutput::show_pose(const LogRecord& record, const LivePose& pose) {
  const Laser& laser = laser_of(record.sensor);
  if (server_.num_clients() == 0) return;
  if (server_.is_wanted(laser.channel)) {
    ros::LaserScan scan;
    laser_scan_from_scan(record.scan, laser.frame, scan);
    publish(laser.channel, pose.stamp, scan);
  }
  // The viewer knows no other transforms than these: the whole way from the map to the laser.
  ros::TfMessage transforms = transforms_message(pose, frames_, false);
  transforms.transforms.push_back(
      transform_from_pose(pose.stamp, frames_.base, laser.frame, record.scan.T_base_sensor));
  publish(transforms_, pose.stamp, transforms);
  if (pose.is_placed) publish(pose_, pose.stamp, pose_message(pose, frames_));
}

void FoxgloveOutput::show_map(const LiveMapPtr& map) {
  const Timestamp stamp = map->map.scans.empty() ? Timestamp{} : map->map.scans.back().stamp;
  publish(map_, stamp, message_from_grid(map->grid, frames_.map, stamp));
  ros::CdrWriter writer;
  encode_closure_markers(lines_of_closures(map->map), stamp, writer);
  server_.publish(closures_, stamp, writer.message());
  encode_closure_markers(crosses_of_doubts(map->map), stamp, writer);
  server_.publish(doubts_, stamp, writer.message());
}

void FoxgloveOutput::show_way(const Trajectory& way) {
  if (!way.empty()) publish(path_, way.back().stamp, path_message(way, frames_));
}

}  // namespace setsquare::live_app
