// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/live/ros2_node.hpp"

#include <fmt/core.h>

#include <chrono>
#include <cstring>
#include <utility>

#include "apps/live/said_poses.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/core/joined.hpp"
#include "setsquare/io/logs/bag/scan_messages.hpp"
#include "setsquare/io/ros/message_encoder.hpp"

namespace setsquare::live_app {
namespace {

constexpr std::size_t kHeaderBytes = 4;  ///< Of a message; replies are written behind theirs.
constexpr const char* kOwnServices = "/setsquare/";
constexpr const char* kSlamToolboxServices = "/slam_toolbox/";

std::string behind_header(const ros::CdrWriter& writer) {
  return writer.message().substr(kHeaderBytes);
}

/// std_srvs/Trigger's and SetBool's reply.
std::string success_reply(bool is_done, const std::string& message) {
  ros::CdrWriter writer;
  writer.write(static_cast<std::uint8_t>(is_done));
  writer.write_text(message);
  return behind_header(writer);
}

std::string byte_reply(std::uint8_t value) { return {static_cast<char>(value)}; }

bool first_flag(std::string_view request) { return !request.empty() && request.front() != 0; }

/// A string that is all of a request; empty where it is none.
std::string text_of(std::string_view request) {
  std::uint32_t size = 0;
  if (request.size() < sizeof size) return {};
  std::memcpy(&size, request.data(), sizeof size);
  if (size == 0 || size > request.size() - sizeof size) return {};
  return std::string(request.substr(sizeof size, size - 1));
}

Timestamp stamp_of(const LiveMap& map) {
  return map.map.scans.empty() ? Timestamp{} : map.map.scans.back().stamp;
}

std::string get_map_reply(LiveSession& session, const FrameNames& frames) {
  ros::CdrWriter writer;
  const LiveMapPtr map = session.last_map();
  ros::OccupancyGrid message;
  message.frame_id = frames.map;
  if (map) message = message_from_grid(map->grid, frames.map, stamp_of(*map));
  ros::encode(message, writer);
  return behind_header(writer);
}

/// What `save` says, or why it could not.
std::pair<bool, std::string> saved(const Ros2Node::Save& save, const std::string& name) {
  try {
    return {true, save(name)};
  } catch (const std::exception& error) {
    return {false, error.what()};
  }
}

/// Scans and odometry come from one publisher; transforms do from many. Best effort hears reliable
/// publishers, too.
struct Subscribed {
  dds::TopicQos qos;
  bool has_one_source = false;
};

Subscribed subscribed_as(const std::string& topic, const std::string& type) {
  if (topic == "/tf_static") return {dds::kStaticTransformQos};
  if (type == "tf2_msgs/msg/TFMessage") return {dds::kTransformQos};
  if (type == "nav_msgs/msg/Odometry") return {{.is_reliable = false, .depth = 100}, true};
  return {dds::kSensorQos, true};
}

}  // namespace

std::vector<std::pair<std::string, std::string>> topics_of(const Ros2Options& options) {
  std::vector<std::pair<std::string, std::string>> topics = {
      {"/tf_static", "tf2_msgs/msg/TFMessage"}, {"/tf", "tf2_msgs/msg/TFMessage"}};
  if (!options.odometry_topic.empty()) {
    topics.emplace_back(options.odometry_topic, "nav_msgs/msg/Odometry");
  }
  for (const std::string& topic : options.scan_topics) {
    topics.emplace_back(topic, "sensor_msgs/msg/LaserScan");
  }
  return topics;
}

std::vector<std::string> faults_of(const MessageQueue& queue) {
  std::vector<std::string> faults;
  if (queue.num_dropped() > 0) {
    faults.push_back(fmt::format("{} messages dropped: too many came", queue.num_dropped()));
  }
  if (queue.num_left_out() > 0) {
    faults.push_back(fmt::format("{} messages left out: damaged, or against what others say",
                                 queue.num_left_out()));
  }
  return faults;
}

Timestamp world_time() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return {std::chrono::duration_cast<std::chrono::nanoseconds>(now).count()};
}

Ros2Node::Ros2Node(const Ros2Options& options, MessageQueue& queue)
    : options_(options), queue_(queue) {
  participant_ = std::make_unique<dds::Participant>(dds::ParticipantOptions{
      .domain = options.domain, .node_name = "setsquare", .is_local = options.is_local});
  const dds::TopicQos pose_qos{.depth = 10};
  transforms_ = participant_->advertise("/tf", "tf2_msgs/msg/TFMessage", dds::kTransformQos);
  pose_ = participant_->advertise("/pose", "geometry_msgs/msg/PoseWithCovarianceStamped", pose_qos);
  map_ = participant_->advertise("/map", "nav_msgs/msg/OccupancyGrid", dds::kMapQos);
  metadata_ = participant_->advertise("/map_metadata", "nav_msgs/msg/MapMetaData", dds::kMapQos);
  path_ = participant_->advertise("/path", "nav_msgs/msg/Path", dds::kMapQos);
  diagnostics_ =
      participant_->advertise("/diagnostics", "diagnostic_msgs/msg/DiagnosticArray", pose_qos);
}

Ros2Node::~Ros2Node() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  is_ending_told_.notify_all();
  if (teller_.joinable()) teller_.join();
  participant_.reset();
}

// --- What comes ----------------------------------------------------------------------------------

void Ros2Node::listen() {
  for (const auto& [topic, type] : topics_of(options_)) subscribe(topic, type);
}

void Ros2Node::subscribe(const std::string& topic, const std::string& type) {
  const MessageTopic added{.name = topic,
                           .type = plain_type_name(type),
                           .definition = {},
                           .encoding = MessageEncoding::kCdr};
  const std::size_t index = queue_.add(added);
  const Subscribed subscribed = subscribed_as(topic, type);
  OnePublisher* one = nullptr;
  if (subscribed.has_one_source) {
    const std::lock_guard lock(mutex_);
    one = &publishers_.try_emplace(topic, added).first->second;
  }
  participant_->subscribe(
      topic, type, subscribed.qos, [this, one, index](std::string_view cdr, std::uint64_t writer) {
        if (one != nullptr) {
          const std::lock_guard lock(mutex_);
          if (!one->hears(writer, cdr, Clock::now())) return;
        }
        queue_.push(index, world_time(), cdr);
      });
}

void Ros2Node::hear_poses(LiveSession& session) {
  said_poses_ = std::make_shared<SaidPoses>(session, options_.frames.map);
  participant_->subscribe(
      kSaidPoseTopic,
      kSaidPoseType,
      {.depth = 10},
      [poses = said_poses_](std::string_view cdr, std::uint64_t) { poses->take(cdr); });
}

// --- What goes -----------------------------------------------------------------------------------

template <typename Message>
void Ros2Node::publish(dds::Publisher& publisher, const Message& message) {
  ros::CdrWriter writer;
  ros::encode(message, writer);
  publisher.publish(writer.message());
}

void Ros2Node::show_pose(const LogRecord& /*record*/, const LivePose& pose) {
  has_wheels_ = has_wheels_ || pose.has_wheels;
  const ros::TfMessage transforms = transforms_message(pose, options_.frames, has_wheels_);
  if (!transforms.transforms.empty()) publish(*transforms_, transforms);
  if (pose.is_placed) publish(*pose_, pose_message(pose, options_.frames));
  const std::lock_guard lock(mutex_);
  last_pose_ = Clock::now();
  ++num_poses_;
}

void Ros2Node::show_map(const LiveMapPtr& map) {
  const ros::OccupancyGrid grid = message_from_grid(map->grid, options_.frames.map, stamp_of(*map));
  publish(*map_, grid);
  ros::CdrWriter writer;
  ros::encode_metadata(grid, writer);
  metadata_->publish(writer.message());
}

void Ros2Node::show_way(const Trajectory& way) {
  publish(*path_, path_message(way, options_.frames));
}

// --- Requests ------------------------------------------------------------------------------------

void Ros2Node::serve(LiveSession& session, Save save) {
  hear_poses(session);
  serve_own(session, save);
  if (options_.has_slam_toolbox_names) serve_as_slam_toolbox(session, save);
  teller_ = std::thread([this, &session] { tell_until_end(session); });
}

void Ros2Node::serve_own(LiveSession& session, const Save& save) {
  const std::string names = kOwnServices;
  participant_->serve(names + "save_map", "std_srvs/srv/Trigger", [save](std::string_view) {
    const auto [is_done, message] = saved(save, "");
    return success_reply(is_done, message);
  });
  participant_->serve(
      names + "pause", "std_srvs/srv/SetBool", [&session](std::string_view request) {
        session.pause(first_flag(request));
        return success_reply(true, first_flag(request) ? "paused" : "mapping");
      });
  participant_->serve(names + "reset", "std_srvs/srv/Trigger", [&session](std::string_view) {
    session.reset();
    return success_reply(true, "the map begins again with the next scan");
  });
  participant_->serve(names + "get_map", "nav_msgs/srv/GetMap", [&session, this](std::string_view) {
    return get_map_reply(session, options_.frames);
  });
}

/// The services of slam_toolbox that have a meaning here, with their types and result codes.
void Ros2Node::serve_as_slam_toolbox(LiveSession& session, const Save& save) {
  constexpr std::uint8_t kSuccess = 0;
  constexpr std::uint8_t kNoMapReceived = 1;
  constexpr std::uint8_t kUndefinedFailure = 255;
  const std::string names = kSlamToolboxServices;
  participant_->serve(
      names + "dynamic_map", "nav_msgs/srv/GetMap", [&session, this](std::string_view) {
        return get_map_reply(session, options_.frames);
      });
  participant_->serve(names + "pause_new_measurements",
                      "slam_toolbox/srv/Pause",
                      [&session](std::string_view) {  // a switch, as there
                        session.pause(!session.is_paused());
                        return byte_reply(1);
                      });
  participant_->serve(
      names + "reset", "slam_toolbox/srv/Reset", [&session](std::string_view request) {
        session.pause(first_flag(request));
        session.reset();
        return byte_reply(kSuccess);
      });
  participant_->serve(
      names + "save_map", "slam_toolbox/srv/SaveMap", [&session, save](std::string_view request) {
        if (!session.last_map()) return byte_reply(kNoMapReceived);
        return byte_reply(saved(save, text_of(request)).first ? kSuccess : kUndefinedFailure);
      });
}

// --- How it goes ---------------------------------------------------------------------------------

void Ros2Node::tell_until_end(LiveSession& session) {
  constexpr std::chrono::seconds kPeriod(1);
  std::unique_lock lock(mutex_);
  while (!is_ending_told_.wait_for(lock, kPeriod, [this] { return is_ending_; })) {
    lock.unlock();
    publish(*diagnostics_, diagnostics(session));
    lock.lock();
  }
}

std::vector<std::string> Ros2Node::faults_of_input() const {
  std::vector<std::string> faults = faults_of(queue_);
  if (const std::uint64_t num_refused = participant_->num_refused(); num_refused > 0) {
    faults.push_back(fmt::format("{} messages refused: too large, or none", num_refused));
  }
  if (said_poses_ && said_poses_->num_refused() > 0) {
    faults.push_back(
        fmt::format("{}: {} messages left out", kSaidPoseTopic, said_poses_->num_refused()));
  }
  const std::lock_guard lock(mutex_);
  for (const auto& [topic, publisher] : publishers_) {
    if (publisher.num_of_others() == 0) continue;
    faults.push_back(fmt::format("{} is published by several nodes: {} messages of others left out",
                                 topic,
                                 publisher.num_of_others()));
  }
  return faults;
}

ros::DiagnosticArray Ros2Node::diagnostics(const LiveSession& session) {
  LiveReport report = session.report();
  std::vector<std::string>& warnings = report.warnings;
  {
    const std::lock_guard lock(mutex_);
    const auto silent = Clock::now() - last_pose_;
    if (silent > OnePublisher::kSilence) {
      warnings.push_back(
          fmt::format("no scan for {:.0f} s", std::chrono::duration<double>(silent).count()));
    }
  }
  if (session.is_paused()) warnings.emplace_back("paused");
  const std::vector<std::string> faults = faults_of_input();
  warnings.insert(warnings.end(), faults.begin(), faults.end());
  report.values.emplace_back("messages dropped", std::to_string(queue_.num_dropped()));
  report.values.emplace_back("messages left out", std::to_string(queue_.num_left_out()));
  report.values.emplace_back("messages refused", std::to_string(participant_->num_refused()));
  ros::DiagnosticStatus status;
  status.name = "setsquare: " + report.task;
  status.message = warnings.empty() ? report.doing : joined(warnings, "; ");
  if (!warnings.empty()) status.level = ros::DiagnosticStatus::Level::kWarning;
  status.values = std::move(report.values);
  return {.stamp = world_time(), .statuses = {status}};
}

}  // namespace setsquare::live_app
