// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "apps/live/live_output.hpp"
#include "apps/live/ros2_messages.hpp"
#include "setsquare/foxglove/server.hpp"

namespace setsquare::live_app {

/// Shows live mapping to Foxglove and others: the scans where they were taken, the map, the way so
/// far, closures and doubts.
class FoxgloveOutput final : public LiveOutput {
 public:
  FoxgloveOutput(foxglove::Server& server, FrameNames frames);

  void show_pose(const LogRecord& record, const LivePose& pose) override;
  void show_map(const LiveMapPtr& map) override;
  void show_way(const Trajectory& way) override;

 private:
  struct Laser {
    std::uint32_t channel = 0;
    std::string frame;
  };

  Laser& laser_of(const std::string& sensor);
  std::uint32_t add_channel(const std::string& topic, const std::string& type, bool is_latched);
  template <typename Message>
  void publish(std::uint32_t channel, Timestamp stamp, const Message& message);

  foxglove::Server& server_;
  FrameNames frames_;
  std::uint32_t transforms_;
  std::uint32_t pose_;
  std::uint32_t map_;
  std::uint32_t path_;
  std::uint32_t closures_;
  std::uint32_t doubts_;
  std::map<std::string, Laser> lasers_;  ///< By sensor; of the same thread.
};

}  // namespace setsquare::live_app
