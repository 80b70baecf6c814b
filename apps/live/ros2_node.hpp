// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "apps/live/live_output.hpp"
#include "apps/live/ros2_messages.hpp"
#include "apps/live/said_poses.hpp"
#include "setsquare/dds/participant.hpp"
#include "setsquare/live/live_session.hpp"
#include "setsquare/live/message_queue.hpp"
#include "setsquare/live/one_publisher.hpp"

namespace setsquare::live_app {

struct Ros2Options {
  int domain = 0;
  bool is_local = true;  ///< This machine's nodes alone.
  std::vector<std::string> scan_topics = {"/scan"};
  std::string odometry_topic = "/odom";
  FrameNames frames;
  bool has_slam_toolbox_names = false;  ///< Services as slam_toolbox has them, too.
};

/// The topics that live mapping reads, with their types, mountings first.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> topics_of(
    const Ros2Options& options);

/// What is wrong with what has come into a queue, a few words each.
[[nodiscard]] std::vector<std::string> faults_of(const MessageQueue& queue);

/// Of the world's clock, as log times are.
[[nodiscard]] Timestamp world_time();

/// Live mapping, or localisation, as a node of a ROS 2 system.
///
/// Subscribes to scans, odometry, /tf and /tf_static, which go into a queue, and to /initialpose.
/// Publishes /tf (map -> odom) and /pose at each scan, /map and /map_metadata with each new map,
/// /path, /diagnostics each second. Serves /setsquare/{save_map, pause, reset, get_map}.
class Ros2Node final : public LiveOutput {
 public:
  /// Saves a map; the answer is where, or throws Error.
  using Save = std::function<std::string(const std::string& name)>;

  /// The queue must outlive the node.
  Ros2Node(const Ros2Options& options, MessageQueue& queue);
  ~Ros2Node() override;
  Ros2Node(const Ros2Node&) = delete;
  Ros2Node& operator=(const Ros2Node&) = delete;

  /// Messages come from now on.
  void listen();
  /// Answers requests, and tells how the session does, until the node ends. The session must
  /// outlive the node.
  void serve(LiveSession& session, Save save);

  /// What is wrong with what has come, a few words each. By any thread.
  [[nodiscard]] std::vector<std::string> faults_of_input() const;

  void show_pose(const LogRecord& record, const LivePose& pose) override;
  void show_map(const LiveMapPtr& map) override;
  void show_way(const Trajectory& way) override;

 private:
  using Clock = std::chrono::steady_clock;

  void subscribe(const std::string& topic, const std::string& type);
  /// /initialpose: where somebody says that the robot is.
  void hear_poses(LiveSession& session);
  void serve_own(LiveSession& session, const Save& save);
  void serve_as_slam_toolbox(LiveSession& session, const Save& save);
  void tell_until_end(LiveSession& session);
  [[nodiscard]] ros::DiagnosticArray diagnostics(const LiveSession& session);
  template <typename Message>
  void publish(dds::Publisher& publisher, const Message& message);

  Ros2Options options_;
  MessageQueue& queue_;
  std::shared_ptr<dds::Publisher> transforms_;
  std::shared_ptr<dds::Publisher> pose_;
  std::shared_ptr<dds::Publisher> map_;
  std::shared_ptr<dds::Publisher> metadata_;
  std::shared_ptr<dds::Publisher> path_;
  std::shared_ptr<dds::Publisher> diagnostics_;
  bool has_wheels_ = false;  ///< Of the thread that tracks.

  std::shared_ptr<SaidPoses> said_poses_;

  mutable std::mutex mutex_;  ///< All below.
  std::condition_variable is_ending_told_;
  bool is_ending_ = false;
  std::map<std::string, OnePublisher> publishers_;  ///< By topic, of those that one may speak on.
  Clock::time_point last_pose_ = Clock::now();
  std::size_t num_poses_ = 0;

  std::thread teller_;
  std::unique_ptr<dds::Participant> participant_;  ///< The last: its threads use the others.
};

}  // namespace setsquare::live_app
