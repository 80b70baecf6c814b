// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare live`: maps while the robot drives.
#include <fmt/core.h>

#include <algorithm>
#include <CLI/App.hpp>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "apps/live/live_options.hpp"
#include "apps/live/live_run.hpp"
#include "apps/live/params_file.hpp"
#include "apps/live/ros2_domain.hpp"
#include "apps/live/stop_signal.hpp"
#include "apps/live/subcommands.hpp"
#include "apps/setsquare/command_line/options.hpp"
#include "apps/setsquare/scans/log_options.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/core/joined.hpp"

namespace setsquare::live_app {
namespace {

/// An option of the command line as a parameter of a node has it. What slam_toolbox calls alike
/// means the same.
struct NamedOption {
  const char* parameter;
  const char* option;
};
constexpr NamedOption kNamedOptions[] = {{"scan_topic", "--scan-topic"},
                                         {"odom_topic", "--odom-topic"},
                                         {"map_frame", "--map-frame"},
                                         {"odom_frame", "--odom-frame"},
                                         {"base_frame", "--base-frame"},
                                         {"map_update_interval", "--map-period"}};

/// slam_toolbox's "map_file_name" is the map to localise in, or to go on with where "mode" is
/// "mapping"; "map_start_pose" has its heading in rad.
void apply_mode(CLI::App& live, NodeParams& params) {
  const auto first = [&](const char* name) {
    const auto found = params.find(name);
    if (found == params.end() || found->second.empty()) return std::string();
    return found->second.front();
  };
  const std::string mode = first("mode");
  const std::string map = first("map_file_name");
  if (!mode.empty() && mode != "mapping" && mode != "localization") {
    throw ParameterError("mode", "is \"mapping\" or \"localization\", not \"" + mode + "\"");
  }
  const bool is_localising = mode == "localization";
  CLI::Option* localize = live.get_option("--localize");
  CLI::Option* go_on = live.get_option("--continue");
  CLI::Option* start = live.get_option("--start");
  const bool is_given = localize->count() > 0 || go_on->count() > 0;
  if (is_localising && map.empty() && !is_given) {
    throw ParameterError("map_file_name", "names no map to localise in");
  }
  if (!map.empty() && !is_given) {
    CLI::Option* option = is_localising ? localize : go_on;
    option->add_result(map);
    option->run_callback();
  }
  const auto pose = params.find("map_start_pose");
  if (pose != params.end() && pose->second.size() == 3 && localize->count() > 0 &&
      start->count() == 0) {
    start->add_result(pose->second[0]);
    start->add_result(pose->second[1]);
    start->add_result(
        fmt::format("{}", deg_from_rad(std::strtod(pose->second[2].c_str(), nullptr))));
    start->run_callback();
  }
  for (const char* name : {"mode", "map_file_name", "map_start_pose"}) params.erase(name);
}

/// Parameters of the file stand in for options that were not given; others are named.
void apply_params_file(CLI::App& live, const std::string& path) {
  std::vector<std::string> unknown;
  NodeParams params = read_params_file(path);
  apply_mode(live, params);
  for (const auto& [name, values] : params) {
    const auto* named = std::find_if(std::begin(kNamedOptions),
                                     std::end(kNamedOptions),
                                     [&](const auto& known) { return name == known.parameter; });
    if (named == std::end(kNamedOptions)) {
      unknown.push_back(name);
      continue;
    }
    CLI::Option* option = live.get_option(named->option);
    if (option->count() > 0 || values.empty()) continue;
    for (const std::string& value : values) option->add_result(value);
    option->run_callback();
  }
  if (unknown.empty()) return;
  std::cerr << fmt::format("{}: parameters without a meaning here: {}\n", path, joined(unknown));
}

void add_ros2_options(CLI::App& live, const std::shared_ptr<LiveOptions>& options) {
  Ros2Options& ros2 = options->ros2;
  ros2.domain = domain_of_environment();
  live.add_flag("--ros2", options->is_ros2, "As a node of ROS 2, without an installation of it");
  live.add_option(
          "--scan-topic", ros2.scan_topics, "Of sensor_msgs/LaserScan; repeated for each scanner")
      ->type_name("TOPIC")
      ->default_str("/scan");
  live.add_option("--odom-topic",
                  ros2.odometry_topic,
                  "Of nav_msgs/Odometry; where nobody publishes it, the frames odom -> base of /tf")
      ->type_name("TOPIC")
      ->capture_default_str();
  live.add_option("--map-frame", ros2.frames.map, "Frame of the map")
      ->type_name("FRAME")
      ->capture_default_str();
  live.add_option("--odom-frame", ros2.frames.odom, "Frame of the odometry")
      ->type_name("FRAME")
      ->capture_default_str();
  live.add_option("--base-frame", ros2.frames.base, "Frame of the robot, where it has no odometry")
      ->type_name("FRAME")
      ->capture_default_str();
  live.add_flag("--slam-toolbox-names",
                ros2.has_slam_toolbox_names,
                "Serve /slam_toolbox/{dynamic_map, pause_new_measurements, reset, save_map}, too");
  live.add_option("--params-file",
                  options->params_path,
                  "Parameters of a node in a file of ROS 2 (docs/live.md); options given here win")
      ->type_name("YAML");
  add_domain_options(live, ros2.domain, ros2.is_local);
  live.get_option("--network")->each([options](const std::string&) {
    options->server.address = "0.0.0.0";
    options->view.address = "0.0.0.0";
  });
}

}  // namespace

void add_live(CLI::App& application) {
  const auto options = std::make_shared<LiveOptions>();
  CLI::App* live = application.add_subcommand("live", "Map, or localise, while the robot drives");
  app::add_log_options(*live, options->mapping.log);
  // A window of a log has no meaning for what comes now, and --from is where it comes from.
  for (const char* window : {"--from", "--to"}) live->remove_option(live->get_option(window));
  add_ros2_options(*live, options);
  live->add_option("--replay", options->replayed_log, "A log, as if the robot drove now")
      ->type_name("LOG")
      ->excludes("--ros2");
  live->add_option("--from", options->bridge, "A server of the Foxglove protocol: foxglove_bridge")
      ->type_name("ws://HOST:PORT")
      ->excludes("--ros2", "--replay");
  live->add_flag("--foxglove", options->is_shown, "Show scans, map and closures to Foxglove");
  live->add_option("--foxglove-port", options->server.port, "Where; 0: a port that is free")
      ->check(app::whole_number(0, 65535))
      ->type_name("PORT")
      ->capture_default_str();
  live->add_option(
          "--view",
          options->view.port,
          "Show map, scan and pose to browsers of this machine, at http://127.0.0.1:8765 or "
          "another port; 0: one that is free. Buttons save the map and set a pose")
      ->expected(0, 1)
      ->check(app::whole_number(0, 65535))
      ->type_name("PORT");
  live->add_option("--speed", options->speed, "Of --replay, in times the robot's; 0: no waiting")
      ->check(app::number_from(0.0, 1e6))
      ->type_name("X")
      ->capture_default_str();
  live->add_option("--state",
                   options->state_path,
                   "Folder that keeps what comes: a run that was killed goes on")
      ->type_name("DIR")
      ->excludes("--replay");
  live->add_option(
          "--state-period", options->state_period_s, "From one file of --state to the next, in s")
      ->check(app::number_above(0.0))
      ->type_name("S")
      ->capture_default_str();
  live->add_option("-o,--output", options->output_path, "Directory for the map, at the end")
      ->type_name("DIR");
  live->add_option("--localize",
                   options->known_map,
                   "Find the robot in this map instead: a folder that `setsquare map` wrote, its "
                   "map.setsquare, or any map.yaml (nav2)")
      ->type_name("MAP")
      ->excludes("--state");
  live->add_option(
          "--start",
          options->start,
          "With --localize: where the robot starts, to about 1 m and 30 deg: x and y in m, "
          "heading in deg")
      ->delimiter(',')
      ->expected(3)
      ->type_name("X,Y,DEG");
  live->add_option("--continue",
                   options->continued_map,
                   "Map to go on with: map.setsquare, or the folder that `map` wrote. It is only "
                   "read; the robot may begin anywhere in it")
      ->type_name("MAP")
      ->excludes("--localize");
  live->add_option(
          "--map-period", options->live.map_period_s, "Seconds from a map to the next, at least")
      ->check(app::number_above(0.0))
      ->type_name("S")
      ->capture_default_str();
  live->add_option(
          "--known-poses",
          options->live.max_known_poses,
          "Of ground that several visits have covered the newest N scans keep their poses, with "
          "--localize of all scans; older ones are forgotten, so that memory does not grow for "
          "ever. 0: all keep them")
      ->check(app::whole_number(0, std::numeric_limits<std::uint32_t>::max()))
      ->type_name("N")
      ->capture_default_str();
  live->add_flag_callback(
      "--no-odometry",
      [options] { options->mapping.uses_odometry = false; },
      "Use the scans alone");
  live->add_flag_callback(
      "--no-audit",
      [options] { options->mapping.is_audited = false; },
      "Do not match pairs of scans against the maps");
  live->footer(
      "Each scan's pose is there at once; loops are closed and maps drawn beside it. At the end,\n"
      "or by Ctrl-C or SIGTERM, the map is finished: its files are those that `setsquare map`\n"
      "makes of the same scans, but for timing.json. With --localize nothing need be known of "
      "where\n"
      "the robot starts; the files are those of `setsquare localize`. docs/live.md tells what it\n"
      "publishes.\n"
      "Examples:\n"
      "  setsquare live --ros2 -o out\n"
      "  setsquare live --ros2 --state kept -o out\n"
      "  setsquare live --ros2 --scan-topic /front/scan --slam-toolbox-names -o out\n"
      "  setsquare live --ros2 --view -o out\n"
      "  setsquare live --ros2 --localize out                 (in place of AMCL)\n"
      "  setsquare live --ros2 --continue monday -o both\n"
      "  setsquare live --from ws://127.0.0.1:8765 -o out\n"
      "  setsquare live --replay intel.clf --speed 10 --foxglove -o out");
  live->callback([live, options] {
    options->is_viewed = live->get_option("--view")->count() > 0;
    if (!options->params_path.empty()) apply_params_file(*live, options->params_path);
    if (!options->is_ros2 && options->replayed_log.empty() && options->bridge.empty()) {
      throw CLI::RequiredError("--ros2, --from ADDRESS or --replay LOG");
    }
    if (!options->start.empty() && options->known_map.empty()) {
      throw CLI::RequiredError("--start: --localize MAP");
    }
    StopSignal stop;  // Before other threads.
    LiveRun(*options, stop).run();
  });
}

}  // namespace setsquare::live_app
