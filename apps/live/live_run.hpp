// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "apps/live/foxglove_output.hpp"
#include "apps/live/latencies.hpp"
#include "apps/live/live_options.hpp"
#include "apps/live/live_output.hpp"
#include "apps/live/ros2_node.hpp"
#include "apps/live/said_poses.hpp"
#include "apps/live/stop_signal.hpp"
#include "apps/live/view_output.hpp"
#include "setsquare/foxglove/client.hpp"
#include "setsquare/foxglove/server.hpp"
#include "setsquare/live/journal.hpp"
#include "setsquare/live/localizing_session.hpp"
#include "setsquare/live/mapping_session.hpp"
#include "setsquare/live/message_queue.hpp"

namespace setsquare::live_app {

/// A run of `setsquare live`: where scans come from, the session that maps or localises them, and
/// who is shown what it finds.
class LiveRun {
 public:
  /// Throws FileError, FormatError, ParameterError.
  LiveRun(const LiveOptions& options, StopSignal& stop);
  ~LiveRun();
  LiveRun(const LiveRun&) = delete;
  LiveRun& operator=(const LiveRun&) = delete;

  /// Goes on until the log ends or the program is asked to stop; tells how it went and writes what
  /// was found.
  /// Throws the same.
  void run();

 private:
  using Clock = std::chrono::steady_clock;

  void open_replayed_log();
  /// Messages of a network, behind those that an earlier run has kept.
  void open_network();
  void make_session();
  [[nodiscard]] LiveWatcher watcher();
  void make_view();
  /// On the session's thread, when all has been read that was kept: from now on messages come.
  void begin_live();
  [[nodiscard]] foxglove::Client::Calls bridge_calls();

  void show_pose(const LogRecord& record, const LivePose& pose);
  void show_map(const LiveMapPtr& map);
  void show_way(const Trajectory& way);
  void end_shows();
  /// A map of now, as somebody on the network asks for: below the output folder, nowhere else.
  std::string save_now(const std::string& name);
  std::string save(const MappedLog& mapped, const std::filesystem::path& folder) const;
  std::string save(const LocalizedLog& log, const std::filesystem::path& folder) const;
  /// Throws FileError where the folder holds the map that is gone on with.
  void refuse_known_map(const std::filesystem::path& folder) const;
  void map();
  void localize();
  void tell(const MappedLog& mapped) const;
  void tell_localised() const;
  /// What both kinds of run tell of their input.
  void tell_input() const;

  LiveOptions options_;
  StopSignal& stop_;
  std::string name_;                            ///< Of the log.
  std::function<Clock::time_point()> arrival_;  ///< Of the last record.
  std::unique_ptr<Journal> journal_;            ///< Null where nothing is kept.
  std::unique_ptr<LogReader> log_;
  MessageQueue* queue_ = nullptr;          ///< Part of log_, where messages come by a network.
  std::vector<std::string> input_faults_;  ///< As of end_shows().
  Latencies latencies_;
  std::atomic<bool> is_live_ = false;  ///< Else what is read was kept: nobody is shown it again.

  std::mutex outputs_mutex_;
  std::vector<LiveOutput*> outputs_;
  std::unique_ptr<foxglove::Server> server_;
  std::unique_ptr<FoxgloveOutput> viewers_;
  std::unique_ptr<MappingSession> mapping_;  ///< One of these two ...
  std::unique_ptr<LocalizingSession> localising_;
  LiveSession* session_ = nullptr;            ///< ... which is this.
  std::shared_ptr<SaidPoses> said_poses_;     ///< By the bridge.
  std::unique_ptr<ViewOutput> view_;          ///< Its threads use the session.
  std::unique_ptr<Ros2Node> node_;            ///< Likewise.
  std::unique_ptr<foxglove::Client> bridge_;  ///< Its thread uses the queue.
};

}  // namespace setsquare::live_app
