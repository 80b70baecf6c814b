// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare localize MAP LOG -o DIR`: where the robot was in a map, scan by scan.
#include <fmt/core.h>

#include <chrono>
#include <CLI/App.hpp>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "apps/setsquare/command_line/options.hpp"
#include "apps/setsquare/command_line/parse.hpp"
#include "apps/setsquare/localize/outputs.hpp"
#include "apps/setsquare/outputs/output_set.hpp"
#include "apps/setsquare/preset.hpp"
#include "apps/setsquare/progress_bar.hpp"
#include "apps/setsquare/scans/log_options.hpp"
#include "apps/setsquare/subcommands.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/core/joined.hpp"
#include "setsquare/io/logs/open_log.hpp"
#include "setsquare/pipeline/localize_log.hpp"

namespace setsquare::app {
namespace {

struct LocalizeOptions {
  std::string map_path;
  std::string log_path;
  std::string output_path;
  bool is_of_sensor = false;
  std::vector<double> start;  ///< x and y in m, heading in deg; empty: not known.
  LocalizeLogOptions localising;
};

void tell_localised(const LocalizedLog& log, double total_s) {
  const LocalisationCounts counts = counts_of(log);
  const std::size_t num_scans = log.poses.size();
  std::cout << fmt::format("{} scans: localised {}, ambiguous {}, lost {}\n",
                           num_scans,
                           counts.num_localised,
                           counts.num_ambiguous,
                           counts.num_lost);
  if (counts.first_localised) {
    const LocalisedPose& first = log.poses[*counts.first_localised];
    std::cout << fmt::format(
        "found at scan {} of {}: x {:.2f} m, y {:.2f} m, heading {:.1f} deg (probability {:.3f})\n",
        *counts.first_localised,
        num_scans,
        first.T_map_base.x_m,
        first.T_map_base.y_m,
        deg_from_rad(first.T_map_base.theta_rad),
        first.probability);
  } else {
    std::cout << "not found: no place of the map stands alone; localisation.tsv has what is "
                 "possible\n";
  }
  std::cout << fmt::format("localised and written in {:.2f} s ({:.0f} us per scan)\n",
                           total_s,
                           1e6 * total_s / static_cast<double>(num_scans));
}

void localize(LocalizeOptions options) {
  const auto start = std::chrono::steady_clock::now();
  if (!options.start.empty()) {
    options.localising.T_map_base_start =
        Pose2{options.start[0], options.start[1], wrap_to_pi(rad_from_deg(options.start[2]))};
  }
  const auto reader = open_log(options.log_path, options.localising.log);
  OutputSet outputs(
      options.output_path, localize_output_names(), {options.log_path, options.map_path});
  const MapToLocaliseIn map = read_map_to_localise_in(options.map_path);
  LocalizedLog log;
  {
    ProgressBar progress("localising");
    log = localize_log(
        *reader,
        options.log_path,
        map.known,
        options.localising,
        {.on_progress = [&](std::optional<double> fraction) { progress.advance(fraction); }});
  }
  const PoseOf pose_of = options.is_of_sensor ? PoseOf::kSensor : PoseOf::kBase;
  for (const auto& [file, bytes] : localize_outputs(log, map.grid, options.map_path, pose_of)) {
    outputs.add(file, bytes);
  }
  outputs.commit();
  const double total_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  tell_localised(log, total_s);
  std::cout << fmt::format("written: {}/{}\n", options.output_path, joined(outputs.added()));
  tell_problems(log.name, log.problems);
}

}  // namespace

void add_localize(CLI::App& application) {
  const auto options = std::make_shared<LocalizeOptions>();
  CLI::App* localize_command = application.add_subcommand(
      "localize", "Where the robot was in a map, scan by scan, from no start pose");
  localize_command
      ->add_option("map",
                   options->map_path,
                   "Folder that `setsquare map` wrote, its map.setsquare, or any map.yaml (nav2)")
      ->type_name("")
      ->required();
  add_log_argument(*localize_command, options->log_path);
  localize_command
      ->add_option("-o,--output", options->output_path, "Directory for the results; made if absent")
      ->type_name("DIR")
      ->required();
  localize_command
      ->add_option("--start",
                   options->start,
                   "Where the robot starts in the map, to about 1 m and 30 deg: x and y in m, "
                   "heading in deg")
      ->delimiter(',')
      ->expected(3)
      ->type_name("X,Y,DEG");
  localize_command->add_flag_callback(
      "--no-odometry",
      [options] { options->localising.uses_odometry = false; },
      "Use the scans alone");
  add_frame_option(*localize_command, options->is_of_sensor);
  add_log_options(*localize_command, options->localising.log);
  localize_command->footer(
      "Nothing need be known of where the robot starts: the whole map is searched until one place\n"
      "stands alone, then it is followed. Writes trajectory.tum (scans that are localised),\n"
      "localisation.tsv (each scan's status, pose, spread and the other places that are "
      "possible),\n"
      "localisation.png and run.json.\n"
      "Examples:\n"
      "  setsquare localize out today.clf -o where\n"
      "  setsquare localize nav2_map.yaml my_bag -o where\n"
      "  setsquare localize out today.clf -o where --start 3.5,-1,90");
  localize_command->callback([options] { localize(*options); });
}

}  // namespace setsquare::app
