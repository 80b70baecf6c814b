// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "setsquare/io/logs/log_reader.hpp"
#include "setsquare/live/live_mapper.hpp"
#include "setsquare/live/live_pose.hpp"
#include "setsquare/pipeline/log_intake.hpp"
#include "setsquare/pipeline/map_log.hpp"

namespace setsquare {

/// Is told what a session finds. Any may be empty.
struct LiveWatcher {
  /// After each scan, on the session's thread, which tracks: must return at once.
  std::function<void(const LogRecord& record, const LivePose& pose)> on_pose = {};
  /// Each new map, on the thread that draws.
  LiveMapper::OnMap on_map = {};
  /// A scan that cannot be mapped, and why.
  std::function<void(const LogRecord& record, const std::string& reason)> on_refused = {};
  /// All is forgotten; on the session's thread.
  std::function<void()> on_reset = {};
};

/// A run of live mapping: from a log that comes while the robot drives, or as if it did, to its
/// map. What map_log() does, with poses and maps on the way, and with a robot's wishes: pause,
/// reset, a map now.
class LiveSession {
 public:
  /// `name`: of the log, as run.json and messages have it. The preset is the default one. Throws
  /// ParameterError.
  LiveSession(std::string name,
              const MapLogOptions& options,
              const LiveMapperParams& params,
              LiveWatcher watcher);

  /// Reads the log until it ends and maps it; then its map, the files of which are those that
  /// map_log() would have given (save_options_of). Throws FileError, FormatError, ParameterError.
  [[nodiscard]] MappedLog run(LogReader& reader);

  // Called by any thread, while run() is.

  /// Whether scans are left out of the map. Poses go on by the wheels.
  void pause(bool is_paused) { is_paused_ = is_paused; }
  [[nodiscard]] bool is_paused() const { return is_paused_; }
  /// Forgets all, before the next scan.
  void reset() { must_reset_ = true; }
  /// See LiveMapper.
  [[nodiscard]] std::future<LiveMapPtr> request_map();
  [[nodiscard]] LiveMapPtr last_map() const;
  [[nodiscard]] LiveCounts counts() const;
  /// A map that was drawn on the way, as map_log() gives one: to be saved. Waits for the next
  /// record, but not long.
  [[nodiscard]] MappedLog mapped_log_of(const LiveMap& map);

 private:
  void add(const LogRecord& record);
  [[nodiscard]] Map finished_map(MappedLog& mapped);
  void begin_again();
  void tell(const LogReader& reader);
  [[nodiscard]] std::shared_ptr<LiveMapper> mapper() const;
  [[nodiscard]] std::shared_ptr<LiveMapper> made_mapper() const;
  [[nodiscard]] LivePose paused_pose(const LogRecord& record) const;

  std::string name_;
  MapLogOptions options_;
  LiveMapperParams params_;
  LiveWatcher watcher_;
  LogIntake intake_;
  std::atomic<bool> is_paused_ = false;
  std::atomic<bool> must_reset_ = false;
  std::atomic<bool> must_tell_ = false;  ///< told_ is to be brought up to date.
  LivePose last_pose_;                   ///< Of the session's thread.

  mutable std::mutex mutex_;  ///< All below.
  std::shared_ptr<LiveMapper> mapper_;
  MappedLog told_;  ///< Everything but the map, as far as is known.
  std::condition_variable is_told_;
};

}  // namespace setsquare
