// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <condition_variable>
#include <future>
#include <memory>
#include <mutex>
#include <string>

#include "setsquare/live/live_mapper.hpp"
#include "setsquare/live/live_session.hpp"
#include "setsquare/pipeline/log_intake.hpp"
#include "setsquare/pipeline/map_log.hpp"

namespace setsquare {

/// A run of live mapping: from a log that comes while the robot drives to its map. What map_log()
/// does, with poses and maps on the way. With MapLogOptions::known_map it goes on with that map.
class MappingSession final : public LiveSession {
 public:
  /// `name`: of the log, as run.json and messages have it. The preset is the default one. Throws
  /// ParameterError.
  MappingSession(std::string name,
                 const MapLogOptions& options,
                 const LiveMapperParams& params,
                 LiveWatcher watcher);

  /// Reads the log until it ends and maps it; then its map, the files of which are those that
  /// map_log() would have given (save_options_of). Throws FileError, FormatError, ParameterError.
  [[nodiscard]] MappedLog run(LogReader& reader);

  // Called by any thread, while run() is.

  /// The robot's pose is that of the map: nobody else can say it.
  bool set_pose(const Pose2& /*T_map_base*/) override { return false; }
  [[nodiscard]] LiveMapPtr last_map() const override { return mapper()->last_map(); }
  [[nodiscard]] LiveReport report() const override;
  /// See LiveMapper.
  [[nodiscard]] std::future<LiveMapPtr> request_map() { return mapper()->request_map(); }
  [[nodiscard]] LiveCounts counts() const { return mapper()->counts(); }
  /// A map that was drawn on the way, as map_log() gives one: to be saved. Waits for the next
  /// record, but not long.
  [[nodiscard]] MappedLog mapped_log_of(const LiveMap& map);

 private:
  [[nodiscard]] bool takes(const LogRecord& record, const LogReader& reader) override {
    return intake_.takes(record, reader);
  }
  [[nodiscard]] LivePose add_scan(const LogRecord& record) override;
  void add_turn_rate(const LogRecord& record) override;
  void begin_again() override;
  void after_record(const LogReader& reader) override;
  [[nodiscard]] bool knows_start() const override { return options_.known_map == nullptr; }

  [[nodiscard]] Map finished_map(MappedLog& mapped);
  void tell(const LogReader& reader);
  [[nodiscard]] std::shared_ptr<LiveMapper> mapper() const;
  [[nodiscard]] std::shared_ptr<LiveMapper> made_mapper() const;

  std::string name_;
  MapLogOptions options_;
  LiveMapperParams params_;
  LogIntake intake_;
  std::atomic<bool> must_tell_ = false;  ///< told_ is to be brought up to date.

  mutable std::mutex mutex_;  ///< All below.
  std::shared_ptr<LiveMapper> mapper_;
  MappedLog told_;  ///< Everything but the map, as far as is known.
  std::condition_variable is_told_;
};

}  // namespace setsquare
