// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/core/trajectory.hpp"
#include "setsquare/io/logs/log_reader.hpp"
#include "setsquare/live/live_pose.hpp"

namespace setsquare::live_app {

/// Somebody who is shown what a session finds: a robot's network, a viewer. None may hold up the
/// session: what cannot be sent at once is dropped.
class LiveOutput {
 public:
  virtual ~LiveOutput() = default;
  /// After each scan, on the thread that tracks.
  virtual void show_pose(const LogRecord& record, const LivePose& pose) = 0;
  /// Each new map, on the thread that draws.
  virtual void show_map(const LiveMapPtr& map) = 0;
  /// The way so far, now and then, on the same thread.
  virtual void show_way(const Trajectory& way) = 0;
};

}  // namespace setsquare::live_app
