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
#include "apps/setsquare/map_outputs.hpp"
#include "apps/setsquare/map_report.hpp"
#include "apps/setsquare/map_run.hpp"
#include "apps/setsquare/map_timing.hpp"
#include "apps/setsquare/output_set.hpp"
#include "apps/setsquare/subcommands.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/io/open_log.hpp"

namespace setsquare::app {
namespace {

std::size_t num_scans_of(const MapRun& run, TrackStatus status) {
  std::size_t count = 0;
  for (const MappedScan& scan : run.track.scans) count += scan.status == status;
  return count;
}

void tell(const MapOptions& options, const MapRun& run, double mapping_s, double outputs_s) {
  const std::size_t num_scans = run.track.scans.size();
  char line[300];
  std::snprintf(line,
                sizeof line,
                "%zu scans, %zu keyframes, %.0f m travelled; degenerate %zu, recovered %zu, lost "
                "%zu\nmapped in %.2f s (%.0f us a scan, reading included), outputs in %.2f s\n",
                num_scans,
                run.track.keyframes.size(),
                path_length_m(run.track),
                num_scans_of(run, TrackStatus::kDegenerate),
                num_scans_of(run, TrackStatus::kRecovered),
                num_scans_of(run, TrackStatus::kLost),
                mapping_s,
                1e6 * mapping_s / static_cast<double>(num_scans),
                outputs_s);
  std::cout << line << "written: " << options.output_path << "/map.png, map.pgm, map.yaml, "
            << "trajectory.tum and more: docs/formats.md\n";
}

void map_log(const MapOptions& options) {
  using Clock = std::chrono::steady_clock;
  const auto seconds_since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  StageClock clock;
  clock.begin("mapping");
  const auto start = Clock::now();
  LogOptions log_options = options.log;
  log_options.scans_only = true;
  const auto reader = open_log(options.log_path, log_options);
  OutputSet outputs(options.output_path, map_output_names());
  const MapRun run = run_map(*reader, options);
  const double mapping_s = seconds_since(start);

  const auto outputs_start = Clock::now();
  write_map_outputs(outputs, options, run, clock);
  tell(options, run, mapping_s, seconds_since(outputs_start));
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
      "Writes trajectory.tum (one pose a scan), map.pgm and map.yaml (for nav2), map.png (for\n"
      "people), graph.g2o, closures.tsv, run.json and timing.json: all of them at the end, or "
      "none.\n"
      "Examples:\n"
      "  setsquare map intel.clf -o out\n"
      "  setsquare map intel.clf -o out --no-odometry");
  map->callback([options] { map_log(*options); });
}

}  // namespace setsquare::app
