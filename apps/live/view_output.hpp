// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "apps/live/live_output.hpp"
#include "setsquare/live/live_session.hpp"
#include "setsquare/view/server.hpp"

namespace setsquare::live_app {

/// Shows a session to browsers: the map as it grows, scan, pose, way, closures and doubts; and does
/// what they ask for: save the map, pause, set a pose. Nothing is made that nobody looks at.
class ViewOutput final : public LiveOutput {
 public:
  /// Saves a map; the answer is where, or throws Error.
  using Save = std::function<std::string(const std::string& name)>;

  /// The session must outlive it. `can_save`: whether there is a place for maps. Throws FileError.
  ViewOutput(const view::ServerOptions& options, LiveSession& session, bool can_save, Save save);
  ~ViewOutput() override;
  ViewOutput(const ViewOutput&) = delete;
  ViewOutput& operator=(const ViewOutput&) = delete;

  void show_pose(const LogRecord& record, const LivePose& pose) override;
  void show_map(const LiveMapPtr& map) override;
  void show_way(const Trajectory& way) override;

  [[nodiscard]] std::uint16_t port() const { return server_.port(); }

 private:
  void tell_until_end();
  [[nodiscard]] std::string carry_out(const std::string& text);

  LiveSession& session_;
  const bool can_save_;
  const Save save_;

  std::mutex mutex_;  ///< All below.
  std::condition_variable is_ending_told_;
  bool is_ending_ = false;
  LiveMapPtr map_;  ///< Not yet told.
  std::optional<Trajectory> way_;
  LivePose pose_;  ///< Of the last scan ...
  Scan scan_;      ///< ... and that scan: whoever opens the page behind it is to see it, too.
  bool has_new_pose_ = false;

  view::Server server_;
  std::thread teller_;
};

}  // namespace setsquare::live_app
