// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "apps/setsquare/map/timing.hpp"
#include "apps/setsquare/preset.hpp"
#include "setsquare/io/logs/faults/finding.hpp"
#include "setsquare/io/logs/log_reader.hpp"
#include "setsquare/map/map.hpp"

namespace setsquare::app {

/// What `setsquare map` was asked to do.
struct MapOptions {
  std::vector<std::string> log_paths;  ///< Of one run, in their order.
  std::string output_path;             ///< A directory; made if it is not there.
  LogOptions log;
  Preset preset = Preset::kDefault;
  bool uses_odometry = true;
  bool is_of_sensor = false;  ///< Poses of the sensor instead of the robot's.
  bool is_audited = true;
  bool is_strict = false;  ///< Doubts make the exit code 3.
  std::size_t num_threads = 1;

  /// How messages and files name the log: its path, or that of the first and how many follow.
  [[nodiscard]] std::string log_name() const;
};

/// A log mapped.
struct MapRun {
  Map map;
  std::string format;
  std::string sensor;
  std::map<std::uint32_t, std::string> scanner_names;  ///< By Scan::scanner.
  LogProblems problems;
  std::vector<LogFinding> findings;  ///< What is wrong with the log, problems included.
};

/// Reads the opened log to its end, scan by scan, and maps it; shows how far it is; `clock`
/// receives the stages. Throws FileError, FormatError, ParameterError.
[[nodiscard]] MapRun run_map(LogReader& reader, const MapOptions& options, StageClock& clock);

}  // namespace setsquare::app
