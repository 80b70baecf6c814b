// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare map LOG -o DIR`: the map of a building, and every scan's pose.
#include <fmt/core.h>

#include <algorithm>
#include <CLI/App.hpp>
#include <CLI/Error.hpp>
#include <CLI/Option.hpp>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "apps/setsquare/audit/verdict_text.hpp"
#include "apps/setsquare/command_line/options.hpp"
#include "apps/setsquare/command_line/parse.hpp"
#include "apps/setsquare/give_back_memory.hpp"
#include "apps/setsquare/map/outputs.hpp"
#include "apps/setsquare/map/timing.hpp"
#include "apps/setsquare/outputs/output_set.hpp"
#include "apps/setsquare/preset.hpp"
#include "apps/setsquare/progress_bar.hpp"
#include "apps/setsquare/scans/findings.hpp"
#include "apps/setsquare/scans/log_options.hpp"
#include "apps/setsquare/subcommands.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/io/logs/log_chain.hpp"
#include "setsquare/io/map_file/map_file.hpp"
#include "setsquare/map/map_summary.hpp"
#include "setsquare/pipeline/map_log.hpp"
#include "setsquare/pipeline/run_sentences.hpp"

namespace setsquare::app {
namespace {

/// What `setsquare map` was asked to do.
struct MapOptions {
  std::vector<std::string> log_paths;  ///< Of one run, in their order.
  std::string output_path;             ///< A directory; made if it is not there.
  bool is_of_sensor = false;           ///< Poses of the sensor instead of the robot's.
  bool is_strict = false;              ///< Doubts make the exit code 3.
  std::string known_map_path;          ///< A map to go on with, or its folder; empty: none.
  MapLogOptions mapping;
};

double seconds_of(const StageClock& clock) {
  double sum_s = 0.0;
  for (const StageTime& stage : clock.stages()) sum_s += stage.wall_s;
  return sum_s;
}

/// What the map leaves out and where it is uncertain, one line each.
void tell_doubts(const MapSummary& summary) {
  if (summary.num_unjoined_pieces > 0) {
    std::cout << "left out: " << summary.num_unjoined_pieces << " pieces of track, "
              << summary.num_unjoined_scans << " scans, that could not be joined to the map\n";
  }
  for (const OpenStretch& stretch : summary.open_headings) {
    std::cout << fmt::format(
        "headings are open in scans {} to {}: a round hall's walls do not tell a turn; spread "
        "{:.0f} deg (sigma)\n",
        stretch.first_scan,
        stretch.first_scan + stretch.num_scans - 1,
        deg_from_rad(stretch.heading_sigma_rad));
  }
  if (summary.open_s == 0.0) return;
  std::cout << fmt::format(
      "walls leave a direction open (a bare corridor, a round hall): {:.0f} m in {:.0f} s; the "
      "least "
      "certain stretch is known to {:.2f} m (sigma)\n",
      summary.open_m,
      summary.open_s,
      summary.worst_length_sigma_m);
}

void tell(const MapSummary& summary, double total_s) {
  std::cout << fmt::format(
      "{} scans, {} keyframes, {:.0f} m travelled; degenerate {}, recovered {}, lost {}\n"
      "{} loop closures of {} compared, {} outvoted\n",
      summary.num_scans,
      summary.num_keyframes,
      summary.path_m,
      summary.num_degenerate,
      summary.num_recovered,
      summary.num_lost,
      summary.num_accepted_closures,
      summary.num_compared_closures,
      summary.num_outvoted_closures);
  for (const std::string& sentence : sentences_on_forgotten(summary)) {
    std::cout << sentence << "\n";
  }
  tell_doubts(summary);
  std::cout << fmt::format("mapped and written in {:.2f} s ({:.0f} us per scan)\n",
                           total_s,
                           1e6 * total_s / static_cast<double>(summary.num_scans));
}

/// What is wrong with the log, damaged records and remarks aside (tell_problems).
void tell_findings(std::vector<LogFinding> findings) {
  std::erase_if(findings, [](const LogFinding& finding) {
    return finding.kind == FindingKind::kRemark || finding.kind == FindingKind::kDamagedRecords;
  });
  if (findings.empty()) return;
  std::cout << "what is wrong with the log\n";
  print_findings(findings, std::cout);
}

void tell_run(const MappedLog& mapped) {
  const Map& map = mapped.map;
  for (const std::string& sentence : sentences_on_sessions(map)) std::cout << sentence << "\n";
  for (const std::string& sentence : sentences_on(map.scanners, mapped.scanner_names)) {
    std::cout << sentence << "\n";
  }
  if (map.num_with_odometry > 0 || map.odometry.num_ignored > 0) {
    std::cout << sentence_on(map.odometry) << "\n";
  }
  if (map.gyro.num_samples > 0) std::cout << sentence_on(map.gyro) << "\n";
  if (const std::string on_sweep = sentence_on(map.sweep); !on_sweep.empty()) {
    std::cout << on_sweep << "\n";
  }
}

MappedLog map_log_with_progress(LogReader& reader, const MapOptions& options, StageClock& clock) {
  ProgressBar progress("mapping");
  return map_log(
      reader,
      name_of_logs(options.log_paths),
      options.mapping,
      {.on_progress = [&](std::optional<double> fraction) { progress.advance(fraction); },
       .on_stage = [&](const std::string& stage) { clock.begin(stage); }});
}

void map_command(MapOptions options) {
  if (options.mapping.num_threads == 0) {
    options.mapping.num_threads = std::max(1U, std::thread::hardware_concurrency());
  }
  StageClock clock;
  LogOptions log_options = options.mapping.log;
  log_options.scans_only = false;  // The odometry is surveyed, turn rates are used.
  const auto reader = open_logs(options.log_paths, log_options);
  std::vector<std::string> inputs = options.log_paths;
  if (!options.known_map_path.empty()) {
    inputs.push_back(map_file_at(options.known_map_path));
    auto known = std::make_shared<const SavedMap>(load_map_file(inputs.back()));
    options.mapping.known_map = {known, &known->map};
    options.mapping.known_map_name = options.known_map_path;
  }
  OutputSet outputs(options.output_path, map_output_names(), inputs);
  const MappedLog mapped = map_log_with_progress(*reader, options, clock);
  give_back_memory();
  write_map_outputs(outputs, mapped, options.is_of_sensor ? PoseOf::kSensor : PoseOf::kBase, clock);
  std::cout << verdict_text(mapped.map);
  tell(summary_of(mapped.map), seconds_of(clock));
  tell_run(mapped);
  std::cout << written_text(options.output_path, outputs);
  tell_findings(mapped.findings);
  tell_problems(mapped.name, mapped.problems);
  if (options.is_strict && !mapped.map.doubts.empty()) throw CLI::RuntimeError(kExitDoubtful);
}

}  // namespace

void add_map(CLI::App& application) {
  const auto options = std::make_shared<MapOptions>();
  CLI::App* map =
      application.add_subcommand("map", "Map a log: the building, and every scan's pose");
  add_log_arguments(*map, options->log_paths);
  map->add_option("-o,--output", options->output_path, "Directory for the results; made if absent")
      ->type_name("DIR")
      ->required();
  map->add_option("--continue",
                  options->known_map_path,
                  "Map to go on with: map.setsquare, or the folder that `map` wrote. It is only "
                  "read; the robot may begin anywhere in it")
      ->type_name("MAP");
  map->add_flag_callback(
      "--no-odometry",
      [options] { options->mapping.uses_odometry = false; },
      "Use the scans alone");
  map->add_flag_callback(
      "--no-audit",
      [options] { options->mapping.is_audited = false; },
      "Do not match pairs of scans against the finished map");
  map->add_flag("--strict", options->is_strict, "Exit with 3 where the map is doubtful");
  options->mapping.num_threads = 0;
  map->add_option(
         "--threads", options->mapping.num_threads, "Threads; any number gives the same map")
      ->check(whole_number(1, 1024))
      ->type_name("N")
      ->default_str("one per processor");
  add_preset_option(*map, options->mapping.preset);
  add_frame_option(*map, options->is_of_sensor);
  add_log_options(*map, options->mapping.log);
  map->footer(
      "Writes report.html (to open in a browser), map.png, map.pgm and map.yaml (for nav2),\n"
      "trajectory.tum (the pose of each scan that is placed), pieces/N.tum (of those that are "
      "not),\n"
      "poses.tsv (each scan's pose, spread and doubts), graph.g2o, closures.tsv, run.json,\n"
      "timing.json and map.setsquare (the map itself, of which `setsquare render` makes the "
      "others\n"
      "again): all of them at the end, or none. docs/formats.md describes them.\n"
      "Pairs of scans are matched against the finished map; the first line says whether they "
      "agree.\n"
      "With --continue what the log shows is joined to the map where the two share places, in the\n"
      "map's axes, and kept apart in pieces/N.tum until a later log ties it to the map.\n"
      "Examples:\n"
      "  setsquare map intel.clf -o out\n"
      "  setsquare map tuesday.bag --continue monday -o both\n"
      "  setsquare map intel.clf -o out --no-odometry\n"
      "  setsquare map robot.clf -o out --sensor all --mounting ROBOTLASER2=-0.2,0,180\n"
      "  zcat intel.clf.gz | setsquare map - -o out");
  map->callback([options] { map_command(*options); });
}

}  // namespace setsquare::app
