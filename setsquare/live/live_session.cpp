// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/live_session.hpp"

#include "setsquare/core/error.hpp"

namespace setsquare {

void LiveSession::read(LogReader& reader) {
  while (const LogRecord* record = reader.next()) {
    if (must_reset_.exchange(false)) {
      begin_again();
      last_pose_.reset();
      if (watcher_.on_reset) watcher_.on_reset();
    }
    if (takes(*record, reader)) add(*record);
    after_record(reader);
  }
}

void LiveSession::add(const LogRecord& record) {
  if (record.kind == RecordKind::kTurnRate) {
    if (!is_paused_) add_turn_rate(record);
    return;
  }
  if (is_paused_) {
    last_pose_ = paused_pose(record);
  } else {
    try {
      last_pose_ = add_scan(record);
    } catch (const ParameterError& error) {
      if (watcher_.on_refused) watcher_.on_refused(record, error.what());
      return;
    }
  }
  if (watcher_.on_pose) watcher_.on_pose(record, *last_pose_);
}

LivePose LiveSession::paused_pose(const LogRecord& record) const {
  LivePose pose;
  pose.is_placed = knows_start();
  if (last_pose_) pose = *last_pose_;
  pose.stamp = record.stamp;
  if (const std::optional<Pose2> T_wheels_base = wheels_of(record)) {
    pose.T_odom_base = *T_wheels_base;
    pose.T_map_base = pose.T_map_odom * pose.T_odom_base;
  }
  return pose;
}

}  // namespace setsquare
