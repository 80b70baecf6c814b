// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// ROS 2 on the wire, without ROS: topics and services of serialised messages (CDR). What is sent
// and received stays bytes here; io/ros reads and writes them. This header names no part of the DDS
// library, whose interface changes from version to version: participant.cpp alone does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace setsquare::dds {

/// How a topic's messages are delivered; both sides must agree. All keep the last `depth`.
struct TopicQos {
  bool is_reliable = true;
  bool is_transient_local = false;  ///< Late readers get the last messages, too ("latched").
  int depth = 10;
};

inline constexpr TopicQos kSensorQos{.is_reliable = false, .depth = 5};
inline constexpr TopicQos kTransformQos{.depth = 100};
inline constexpr TopicQos kStaticTransformQos{.is_transient_local = true, .depth = 100};
inline constexpr TopicQos kMapQos{.is_transient_local = true, .depth = 1};

struct ParticipantOptions {
  int domain = 0;                       ///< ROS_DOMAIN_ID, 0 to 232.
  std::string node_name = "setsquare";  ///< As `ros2 node list` shows it.
  /// Bind to the loopback device alone and speak with this machine's nodes; else with the
  /// network's, too.
  bool is_local = true;
};

/// Sends messages of one topic.
class Publisher {
 public:
  virtual ~Publisher() = default;
  /// A whole serialised message, header included. May be called by any thread.
  virtual void publish(std::string_view cdr) = 0;
  /// Readers that are there now.
  [[nodiscard]] virtual int num_matched() const = 0;
};

/// A node of a ROS 2 system.
class Participant {
 public:
  /// Messages of one topic as they come, on the library's threads: must return at once. `writer`
  /// tells publishers apart.
  using OnMessage = std::function<void(std::string_view cdr, std::uint64_t writer)>;
  /// Answers a request: both are the message behind the header of four bytes. On a thread of its
  /// own: may take its time, but other requests wait.
  using OnRequest = std::function<std::string(std::string_view request)>;

  /// Messages beyond it are left out, and counted.
  static constexpr std::size_t kMaxMessageBytes = 64U << 20U;

  /// Throws ParameterError (domain), FileError where the network cannot be used.
  explicit Participant(const ParticipantOptions& options);
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  /// `topic`: "/scan"; `type`: "sensor_msgs/msg/LaserScan".
  [[nodiscard]] std::shared_ptr<Publisher> advertise(const std::string& topic,
                                                     const std::string& type,
                                                     const TopicQos& qos);
  /// Messages of this participant's own publishers are left out.
  void subscribe(const std::string& topic,
                 const std::string& type,
                 const TopicQos& qos,
                 OnMessage on_message);
  /// `service`: "/slam_toolbox/reset"; `type`: "std_srvs/srv/Trigger".
  void serve(const std::string& service, const std::string& type, OnRequest on_request);

  /// Messages that were too large, or none.
  [[nodiscard]] std::uint64_t num_refused() const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

/// "sensor_msgs/msg/LaserScan" to "sensor_msgs::msg::dds_::LaserScan_".
[[nodiscard]] std::string dds_type_name(const std::string& ros_type,
                                        const std::string& suffix = "");

/// The hash by which newer versions of ROS 2 tell types apart, "RIHS01_...": empty where it is not
/// known; then nodes warn and speak with us all the same.
[[nodiscard]] std::string_view type_hash(std::string_view ros_type);

}  // namespace setsquare::dds
