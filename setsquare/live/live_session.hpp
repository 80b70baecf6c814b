// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/core/trajectory.hpp"
#include "setsquare/io/logs/log_reader.hpp"
#include "setsquare/live/live_pose.hpp"

namespace setsquare {

/// Is told what a session finds. Any may be empty.
struct LiveWatcher {
  /// After each scan, on the session's thread, which tracks: must return at once.
  std::function<void(const LogRecord& record, const LivePose& pose)> on_pose = {};
  /// Each new map, on the thread that draws.
  std::function<void(const LiveMapPtr&)> on_map = {};
  /// The way so far (DrivenWay), where it is not that of the map; on the thread that places.
  std::function<void(const Trajectory&)> on_way = {};
  /// A scan that cannot be used, and why.
  std::function<void(const LogRecord& record, const std::string& reason)> on_refused = {};
  /// All is forgotten; on the session's thread.
  std::function<void()> on_reset = {};
};

/// Where a robot may be that is not localised, or may be after all.
struct LikelyPlace {
  Pose2 T_map_base;
  double probability = 0.0;
};

/// How a session does, for people and for /diagnostics.
struct LiveReport {
  std::string task;                   ///< "mapping", "localisation".
  std::string doing;                  ///< "mapping", "localised", "lost".
  std::vector<std::string> warnings;  ///< What is not as it should be, a few words each.
  std::vector<std::pair<std::string, std::string>> values;  ///< Names and figures.
  /// In a known map: where the robot may be, too, the most probable first; where it is not
  /// localised the first of all. None below 1 %.
  std::vector<LikelyPlace> places = {};
};

/// A run on a log that comes while the robot drives, or as if it did, with a robot's wishes: pause,
/// reset. What becomes of the scans is a map (MappingSession) or a place in one
/// (LocalizingSession).
class LiveSession {
 public:
  virtual ~LiveSession() = default;
  LiveSession(const LiveSession&) = delete;
  LiveSession& operator=(const LiveSession&) = delete;

  // Called by any thread, while the session runs.

  /// Whether scans are left out. Poses go on by the wheels.
  void pause(bool is_paused) { is_paused_ = is_paused; }
  [[nodiscard]] bool is_paused() const { return is_paused_; }
  /// Forgets all that the log has shown, before the next scan.
  void reset() { must_reset_ = true; }
  /// Somebody says where the robot is, to about 1 m and 30 deg. Returns whether that has a meaning
  /// here. Throws ParameterError where it is no pose.
  virtual bool set_pose(const Pose2& T_map_base) = 0;
  /// The last map; null before the first.
  [[nodiscard]] virtual LiveMapPtr last_map() const = 0;
  /// How it goes; without what the whole session knows (is_paused).
  [[nodiscard]] virtual LiveReport report() const = 0;

 protected:
  LiveSession(bool uses_odometry, LiveWatcher watcher)
      : uses_odometry_(uses_odometry), watcher_(std::move(watcher)) {}

  /// Reads the log until it ends.
  void read(LogReader& reader);
  /// The robot's pose by the wheels, where it is to be used.
  [[nodiscard]] std::optional<Pose2> wheels_of(const LogRecord& record) const {
    return uses_odometry_ ? record.T_odom_base : std::nullopt;
  }

  // On the session's thread.

  /// Whether the reader's next record is used at all.
  [[nodiscard]] virtual bool takes(const LogRecord& record, const LogReader& reader) = 0;
  /// Throws ParameterError where the scan is none.
  [[nodiscard]] virtual LivePose add_scan(const LogRecord& record) = 0;
  virtual void add_turn_rate(const LogRecord& /*record*/) {}
  /// Forgets all.
  virtual void begin_again() = 0;
  virtual void after_record(const LogReader& /*reader*/) {}
  /// Whether the robot's first pose is known: that of the map.
  [[nodiscard]] virtual bool knows_start() const = 0;

  [[nodiscard]] const LiveWatcher& watcher() const { return watcher_; }

 private:
  void add(const LogRecord& record);
  [[nodiscard]] LivePose paused_pose(const LogRecord& record) const;

  const bool uses_odometry_;
  const LiveWatcher watcher_;
  std::atomic<bool> is_paused_ = false;
  std::atomic<bool> must_reset_ = false;
  std::optional<LivePose> last_pose_;  ///< Of the session's thread.
};

}  // namespace setsquare
