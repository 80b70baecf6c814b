// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare replay`: a log as a robot would publish it.
#include <fmt/core.h>

#include <chrono>
#include <CLI/App.hpp>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "apps/live/ros2_domain.hpp"
#include "apps/live/stop_signal.hpp"
#include "apps/live/subcommands.hpp"
#include "apps/setsquare/command_line/options.hpp"
#include "apps/setsquare/scans/log_options.hpp"
#include "setsquare/dds/participant.hpp"
#include "setsquare/io/logs/bag/ros_log_writer.hpp"
#include "setsquare/io/logs/open_log.hpp"
#include "setsquare/live/paced_log.hpp"

namespace setsquare::live_app {
namespace {

struct ReplayOptions {
  std::string log_path;
  double speed = 1.0;
  double wait_s = 2.0;
  int domain = domain_of_environment();
  bool is_local = true;
  bool is_ros2 = true;  ///< The only way so far.
  LogOptions log;
};

/// Messages to the network instead of into a file. Mute at first: then topics are made, and no
/// more.
class DdsSink final : public MessageSink {
 public:
  explicit DdsSink(dds::Participant& participant) : participant_(participant) {}

  [[nodiscard]] Channel add_channel(const std::string& topic,
                                    const std::string& type,
                                    bool is_latched) override {
    const auto known = std::find(topics_.begin(), topics_.end(), topic);
    if (known != topics_.end()) return static_cast<Channel>(known - topics_.begin());
    const bool is_scan = type == "sensor_msgs/msg/LaserScan";
    const dds::TopicQos qos = is_latched ? dds::kStaticTransformQos
                              : is_scan  ? dds::kSensorQos
                                         : dds::kTransformQos;
    topics_.push_back(topic);
    publishers_.push_back(participant_.advertise(topic, type, qos));
    return publishers_.size() - 1;
  }
  void write(Channel channel, Timestamp /*stamp*/, std::string_view cdr) override {
    if (is_mute_) return;
    publishers_[channel]->publish(cdr);
    ++num_messages_;
  }
  void speak() { is_mute_ = false; }
  [[nodiscard]] std::size_t num_messages() const { return num_messages_; }

 private:
  dds::Participant& participant_;
  std::vector<std::string> topics_;
  std::vector<std::shared_ptr<dds::Publisher>> publishers_;
  bool is_mute_ = true;
  std::size_t num_messages_ = 0;
};

StopSignal::Clock::time_point in_seconds(double seconds) {
  return StopSignal::Clock::now() + std::chrono::duration_cast<StopSignal::Clock::duration>(
                                        std::chrono::duration<double>(seconds));
}

/// Makes the topics that the log begins with.
void advertise(const ReplayOptions& options, DdsSink& sink) {
  RosLogWriter messages(sink);
  const auto log = open_log(options.log_path, options.log);
  while (const LogRecord* record = log->next()) {
    messages.write(*record);
    if (record->kind == RecordKind::kScan) return;
  }
}

void run_replay(ReplayOptions options) {
  StopSignal stop;
  options.log.scans_only = false;
  dds::Participant participant(
      {.domain = options.domain, .node_name = "setsquare_replay", .is_local = options.is_local});
  DdsSink sink(participant);
  if (options.log_path != "-") advertise(options, sink);  // Standard input is read once.
  if (!stop.wait_until(in_seconds(options.wait_s))) return;
  sink.speak();
  PacedLog log(open_log(options.log_path, options.log),
               options.speed,
               [&](PacedLog::Clock::time_point moment) { return stop.wait_until(moment); });
  RosLogWriter messages(sink);
  while (const LogRecord* record = log.next()) {
    if (record->kind != RecordKind::kTruePose) messages.write(*record);
  }
  constexpr double kOnItsWay_s = 0.5;  // What was written last.
  (void)stop.wait_until(in_seconds(kOnItsWay_s));
  std::cout << fmt::format("{} messages published\n", sink.num_messages());
  app::tell_problems(options.log_path, log.problems());
}

}  // namespace

void add_replay(CLI::App& application) {
  const auto options = std::make_shared<ReplayOptions>();
  CLI::App* replay = application.add_subcommand("replay", "Publish a log as a robot would");
  app::add_log_argument(*replay, options->log_path);
  replay->add_flag("--ros2",
                   options->is_ros2,
                   "As a node of ROS 2: scans, /odom, /tf and /tf_static (the default)");
  replay->add_option("--speed", options->speed, "In times the robot's; 0: no waiting")
      ->check(app::number_from(0.0, 1e6))
      ->type_name("X")
      ->capture_default_str();
  replay->add_option("--wait", options->wait_s, "At first, so that readers find us, in s")
      ->check(app::number_from(0.0, 3600.0))
      ->type_name("S")
      ->capture_default_str();
  add_domain_options(*replay, options->domain, options->is_local);
  app::add_log_options(*replay, options->log);
  replay->footer(
      "Examples:\n"
      "  setsquare replay intel.clf --speed 2\n"
      "  setsquare replay my_bag --domain 7");
  replay->callback([options] { run_replay(*options); });
}

}  // namespace setsquare::live_app
