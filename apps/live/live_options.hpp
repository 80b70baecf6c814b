// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "apps/live/ros2_node.hpp"
#include "setsquare/foxglove/server.hpp"
#include "setsquare/live/journal.hpp"
#include "setsquare/live/live_mapper.hpp"
#include "setsquare/pipeline/map_log.hpp"
#include "setsquare/view/server.hpp"

namespace setsquare::live_app {

/// What `setsquare live` was asked to do. Scans come from one of the first three.
struct LiveOptions {
  bool is_ros2 = false;
  std::string bridge;        ///< Address of a server of the Foxglove protocol, or empty.
  std::string replayed_log;  ///< Or empty.
  double speed = 1.0;        ///< Of the replayed log; 0: no waiting.

  Ros2Options ros2;                ///< Topics and frames, whoever carries them.
  bool is_shown = false;           ///< To Foxglove.
  bool is_viewed = false;          ///< In a browser.
  view::ServerOptions view;        ///< Where, then.
  foxglove::ServerOptions server;  ///< Where, then.
  std::string output_path;         ///< Empty: nothing is written.
  std::string known_map;           ///< To localise in; empty: a map is made.
  std::string continued_map;       ///< To go on with; empty: none.
  std::vector<double> start;       ///< Where in the known map: x and y in m, heading in deg.
  std::string state_path;          ///< Empty: a kill loses all.
  double state_period_s = Journal::kPeriod_s;
  std::string params_path;  ///< Empty: none.
  LiveMapperParams live;
  MapLogOptions mapping;

  [[nodiscard]] bool is_of_network() const { return is_ros2 || !bridge.empty(); }
};

}  // namespace setsquare::live_app
