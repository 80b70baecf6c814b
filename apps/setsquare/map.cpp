// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare map LOG -o DIR`: every scan's pose, and a picture of the building.
#include <chrono>
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>

#include "apps/setsquare/log_options.hpp"
#include "apps/setsquare/map_image.hpp"
#include "apps/setsquare/map_report.hpp"
#include "apps/setsquare/map_run.hpp"
#include "apps/setsquare/output_directory.hpp"
#include "apps/setsquare/subcommands.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/core/save_file.hpp"
#include "setsquare/io/open_log.hpp"
#include "setsquare/io/trajectory_tum.hpp"

namespace setsquare::app {
namespace {

std::size_t num_scans_of(const MapRun& run, TrackStatus status) {
  std::size_t count = 0;
  for (const MappedScan& scan : run.track.scans) count += scan.status == status;
  return count;
}

void tell(const MapOptions& options, const MapRun& run, double mapping_s, double picture_s) {
  const std::size_t num_scans = run.track.scans.size();
  char line[300];
  std::snprintf(line,
                sizeof line,
                "%zu scans, %zu keyframes, %.0f m travelled; degenerate %zu, recovered %zu, lost "
                "%zu\nmapped in %.2f s (%.0f us a scan, reading included), picture in %.2f s\n",
                num_scans,
                run.track.keyframes.size(),
                path_length_m(run.track),
                num_scans_of(run, TrackStatus::kDegenerate),
                num_scans_of(run, TrackStatus::kRecovered),
                num_scans_of(run, TrackStatus::kLost),
                mapping_s,
                1e6 * mapping_s / static_cast<double>(num_scans),
                picture_s);
  std::cout << line << "written: " << options.output_path << "/trajectory.tum, map.png, run.json\n";
}

void map_log(const MapOptions& options) {
  using Clock = std::chrono::steady_clock;
  const auto seconds_since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const auto start = Clock::now();
  LogOptions log_options = options.log;
  log_options.scans_only = true;
  const auto reader = open_log(options.log_path, log_options);
  const OutputDirectory directory(options.output_path);
  const MapRun run = run_map(*reader, options);
  const double mapping_s = seconds_since(start);

  const auto picture_start = Clock::now();
  write_trajectory_tum(directory.file("trajectory.tum"),
                       trajectory_from(run.track, options.is_of_sensor));
  save_map_image(run, directory.file("map.png"));
  save_file(directory.file("run.json"), run_json(options, run));
  tell(options, run, mapping_s, seconds_since(picture_start));
  tell_problems(options.log_path, run.problems);
}

}  // namespace

void add_map(CLI::App& application) {
  const auto options = std::make_shared<MapOptions>();
  CLI::App* map = application.add_subcommand("map", "Map a log: every scan's pose and a picture");
  map->add_option("log", options->log_path, "CARMEN log or MRPT rawlog, plain or gzip; - = stdin")
      ->required();
  map->add_option("-o,--output", options->output_path, "Directory for the results; made if absent")
      ->required();
  map->add_flag("!--no-odometry", options->uses_odometry, "Use the scans alone");
  add_preset_option(*map, options->preset);
  add_frame_option(*map, options->is_of_sensor);
  add_log_options(*map, options->log);
  map->footer(
      "Writes trajectory.tum (one pose a scan), map.png and run.json.\n"
      "Examples:\n"
      "  setsquare map intel.clf -o out\n"
      "  setsquare map intel.clf -o out --no-odometry");
  map->callback([options] { map_log(*options); });
}

}  // namespace setsquare::app
