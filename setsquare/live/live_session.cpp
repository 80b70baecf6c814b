// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/live_session.hpp"

#include <chrono>
#include <utility>

#include "setsquare/core/error.hpp"

namespace setsquare {

LiveSession::LiveSession(std::string name,
                         const MapLogOptions& options,
                         const LiveMapperParams& params,
                         LiveWatcher watcher)
    : name_(std::move(name)),
      options_(options),
      params_(params),
      watcher_(std::move(watcher)),
      intake_(options) {
  if (options.preset != Preset::kDefault) {
    throw ParameterError("preset", "live mapping has the default one");
  }
  params_.mapper = mapper_params_of(options);
  told_.name = name_;
  told_.options = options_;
  mapper_ = made_mapper();
}

std::shared_ptr<LiveMapper> LiveSession::made_mapper() const {
  return std::make_shared<LiveMapper>(params_, watcher_.on_map);
}

MappedLog LiveSession::run(LogReader& reader) {
  while (const LogRecord* record = reader.next()) {
    if (must_reset_.exchange(false)) begin_again();
    if (intake_.takes(*record, reader)) add(*record);
    if (must_tell_.exchange(false)) tell(reader);
  }
  tell(reader);
  MappedLog mapped;
  {
    const std::lock_guard lock(mutex_);
    mapped = told_;
  }
  mapped.map = finished_map(mapped);
  require_something_mapped(mapped);
  return mapped;
}

/// Where no map can be made of all that came, the last one that could be.
Map LiveSession::finished_map(MappedLog& mapped) {
  const std::shared_ptr<LiveMapper> mapper = this->mapper();
  try {
    return mapper->finish();
  } catch (const Error& error) {
    const LiveMapPtr last = mapper->last_map();
    if (!last) throw;
    mapped.problems.remarks.push_back("the map could not be finished (" +
                                      std::string(error.what()) + "): it is that of the first " +
                                      std::to_string(last->map.scans.size()) + " scans");
    return last->map;
  }
}

void LiveSession::begin_again() {
  std::shared_ptr<LiveMapper> fresh = made_mapper();
  {
    const std::lock_guard lock(mutex_);
    mapper_.swap(fresh);
  }
  intake_ = LogIntake(options_);
  last_pose_ = {};
  if (watcher_.on_reset) watcher_.on_reset();
}

void LiveSession::tell(const LogReader& reader) {
  {
    const std::lock_guard lock(mutex_);
    intake_.tell(reader, told_);
  }
  is_told_.notify_all();
}

void LiveSession::add(const LogRecord& record) {
  const std::shared_ptr<LiveMapper> mapper = this->mapper();
  if (record.kind == RecordKind::kTurnRate) {
    if (!is_paused_) mapper->add_turn_rate(record.stamp, record.turn_rad_per_s.value_or(0.0));
    return;
  }
  if (is_paused_) {
    last_pose_ = paused_pose(record);
  } else {
    try {
      last_pose_ =
          mapper->add(record.scan, options_.uses_odometry ? record.T_odom_base : std::nullopt);
    } catch (const ParameterError& error) {
      if (watcher_.on_refused) watcher_.on_refused(record, error.what());
      return;
    }
  }
  if (watcher_.on_pose) watcher_.on_pose(record, last_pose_);
}

LivePose LiveSession::paused_pose(const LogRecord& record) const {
  LivePose pose = last_pose_;
  pose.stamp = record.stamp;
  if (options_.uses_odometry && record.T_odom_base) {
    pose.T_odom_base = *record.T_odom_base;
    pose.T_map_base = pose.T_map_odom * pose.T_odom_base;
  }
  return pose;
}

std::shared_ptr<LiveMapper> LiveSession::mapper() const {
  const std::lock_guard lock(mutex_);
  return mapper_;
}

std::future<LiveMapPtr> LiveSession::request_map() { return mapper()->request_map(); }
LiveMapPtr LiveSession::last_map() const { return mapper()->last_map(); }
LiveCounts LiveSession::counts() const { return mapper()->counts(); }

MappedLog LiveSession::mapped_log_of(const LiveMap& map) {
  constexpr std::chrono::seconds kLongestWait(1);
  std::unique_lock lock(mutex_);
  must_tell_ = true;
  is_told_.wait_for(lock, kLongestWait, [this] { return !must_tell_; });
  MappedLog mapped = told_;
  lock.unlock();
  mapped.map = map.map;
  return mapped;
}

}  // namespace setsquare
