// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare audit LOG MAP`: whether the scans of a log agree with a map of it.
#include <fmt/core.h>

#include <algorithm>
#include <CLI/App.hpp>
#include <CLI/Error.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "apps/setsquare/audit/earlier_map.hpp"
#include "apps/setsquare/audit/verdict_text.hpp"
#include "apps/setsquare/command_line/options.hpp"
#include "apps/setsquare/command_line/parse.hpp"
#include "apps/setsquare/preset.hpp"
#include "apps/setsquare/progress_bar.hpp"
#include "apps/setsquare/scans/log_options.hpp"
#include "apps/setsquare/subcommands.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/io/logs/open_log.hpp"
#include "setsquare/map/map_verdict.hpp"
#include "setsquare/mapping/audit/trajectory_audit.hpp"
#include "setsquare/report/map/audit_json.hpp"

namespace setsquare::app {
namespace {

struct AuditOptions {
  std::string log_path;
  std::string map_path;  ///< A folder of `setsquare map`, or a trajectory.
  LogOptions log;
  bool is_of_sensor = false;
  double max_time_difference_s = 0.002;
  std::size_t num_threads = 0;
  bool is_json = false;
  bool is_strict = false;
};

/// The scan where the map has it: `pose` is the robot's or the laser's.
MappedScan placed_by(const EarlierMap& earlier, std::size_t index, const Scan& scan) {
  MappedScan placed = earlier.scans[index];
  const Pose2& pose = earlier.trajectory[index].pose;
  placed.stamp = scan.stamp;
  placed.T_map_sensor = earlier.is_of_sensor ? pose : pose * scan.T_base_sensor;
  placed.T_map_base = earlier.is_of_sensor ? pose * scan.T_base_sensor.inverse() : pose;
  return placed;
}

/// Reads the log and audits the map. Throws Error where no scan has a pose.
Map audited_map(const AuditOptions& options, const EarlierMap& earlier) {
  const auto reader = open_log(options.log_path, options.log);
  PosesOfScans poses(earlier.trajectory, options.max_time_difference_s);
  TrajectoryAudit audit;
  std::size_t num_scans = 0;
  std::size_t num_placed = 0;
  ProgressBar progress("auditing");
  while (const LogRecord* record = reader->next()) {
    progress.advance(reader->fraction_read());
    if (record->kind != RecordKind::kScan) continue;
    ++num_scans;
    const std::size_t index = poses.next(record->scan.stamp);
    if (index >= earlier.trajectory.size()) continue;
    audit.add(record->scan, placed_by(earlier, index, record->scan));
    ++num_placed;
  }
  if (num_placed == 0) {
    throw FormatError(earlier.trajectory_path,
                      "",
                      fmt::format("has no pose at the time of any of the log's {} scans (see "
                                  "--max-time-difference)",
                                  num_scans));
  }
  // Scans are counted from the first one that has a pose.
  const bool is_whole = num_placed == earlier.trajectory.size();
  return audit.finish(is_whole ? earlier.pieces : std::vector<TrackPiece>{},
                      is_whole ? earlier.open_stretches : std::vector<OpenStretch>{},
                      options.num_threads);
}

void audit_log(AuditOptions options) {
  if (options.num_threads == 0) {
    options.num_threads = std::max(1U, std::thread::hardware_concurrency());
  }
  const EarlierMap earlier = read_earlier_map(options.map_path, options.is_of_sensor);
  const Map map = audited_map(options, earlier);
  if (options.is_json) {
    const nlohmann::ordered_json json = {{"verdict", map_verdict(map)},
                                         {"scans", map.scans.size()},
                                         {"keyframes", map.keyframes.size()},
                                         {"audit", json_from_audit(map)},
                                         {"doubts", json_from_doubts(map)}};
    std::cout << json.dump(2) << "\n";
  } else {
    std::cout << verdict_text(map);
  }
  if (options.is_strict && !map.doubts.empty()) throw CLI::RuntimeError(kExitDoubtful);
}

}  // namespace

void add_audit(CLI::App& application) {
  const auto options = std::make_shared<AuditOptions>();
  CLI::App* audit =
      application.add_subcommand("audit", "Whether the scans of a log agree with a map of it");
  add_log_argument(*audit, options->log_path);
  audit
      ->add_option("map",
                   options->map_path,
                   "Folder that `setsquare map` wrote, or any program's trajectory, TUM format")
      ->type_name("")
      ->required();
  audit->add_flag("--json", options->is_json, "Print JSON");
  audit->add_flag("--strict", options->is_strict, "Exit with 3 where the map is doubtful");
  audit
      ->add_option("--max-time-difference",
                   options->max_time_difference_s,
                   "Largest difference of the stamps of a scan and its pose")
      ->check(number_from(0.0, 3600.0))
      ->type_name("S");
  audit->add_option("--threads", options->num_threads, "Threads; any number gives the same answer")
      ->check(whole_number(1, 1024))
      ->type_name("N")
      ->default_str("one per processor");
  add_frame_option(*audit, options->is_of_sensor);
  audit->get_option("--frame")->description(
      "A trajectory's poses are of the robot (base) or of the laser (sensor); a folder says so");
  add_log_options(*audit, options->log);
  audit->footer(
      "Matches pairs of scans without a guess and compares the answers with the map. Writes\n"
      "nothing but its answer.\n"
      "Examples:\n"
      "  setsquare audit intel.clf out\n"
      "  setsquare audit intel.clf gmapping.tum --frame sensor --json\n"
      "  setsquare audit my_bag slam_toolbox.tum --max-time-difference 0.05 --strict");
  audit->callback([options] { audit_log(*options); });
}

}  // namespace setsquare::app
