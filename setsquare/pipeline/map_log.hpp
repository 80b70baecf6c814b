// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// From a log to a map in one call: what the command and the Python package do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "setsquare/io/logs/faults/finding.hpp"
#include "setsquare/io/logs/log_reader.hpp"
#include "setsquare/io/map_file/map_file.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/pipeline/preset.hpp"
#include "setsquare/report/map/save_map.hpp"

namespace setsquare {

/// What decides which map a log gives.
struct MapLogOptions {
  LogOptions log;                    ///< Which part of the log is read, and what it does not state.
  Preset preset = Preset::kDefault;  ///< Which matcher, and with it which mapper.
  bool uses_odometry = true;         ///< Else it is read and left out.
  /// A map to go on with (Mapper): the log's scans come after those of the map. May be null.
  std::shared_ptr<const Map> known_map = nullptr;
  std::string known_map_name = {};  ///< As the user named it.
  bool is_audited = true;       ///< Whether pairs of scans are matched against the finished map.
  std::size_t num_threads = 1;  ///< Any number gives the same map.
};

/// Is told how far map_log is. Either may be empty.
struct MapLogWatcher {
  /// After each record: the share of the log that has been read, 0 to 1, where it is known. What it
  /// throws ends map_log.
  std::function<void(std::optional<double> fraction_read)> on_progress = {};
  /// Before each stage: "tracking and closing", "finishing".
  std::function<void(const std::string& stage)> on_stage = {};
};

/// A log mapped.
struct MappedLog {
  Map map;             ///< What was found.
  std::string name;    ///< Of the log, as run.json and messages have it.
  std::string format;  ///< Of the log: "CARMEN log", "ROS 2 bag".
  std::string sensor;  ///< The laser's name; as it was asked for where several were.
  std::map<std::uint32_t, std::string> scanner_names;  ///< By Scan::scanner.
  LogProblems problems;              ///< Damaged records and the reader's remarks.
  std::vector<LogFinding> findings;  ///< What is wrong with the log, problems included.
  MapLogOptions options;             ///< By which it was mapped.
};

/// How messages and files name a run of several logs: by the first, and how many follow.
[[nodiscard]] std::string name_of_logs(const std::vector<std::string>& paths);

/// "standard input" for "-", else the last part of the path: how a page or a picture names the log.
[[nodiscard]] std::string title_of_log(const std::string& path);

/// Reads logs of one run, one after the other, and maps them: open_logs() and map_log(). Throws
/// FileError, FormatError, ParameterError.
[[nodiscard]] MappedLog map_logs(const std::vector<std::string>& paths,
                                 const MapLogOptions& options = {},
                                 const MapLogWatcher& watcher = {});

/// Reads the opened log to its end, scan by scan, and maps it. Throws FileError, FormatError,
/// ParameterError; FileError, too, where not one of its scans could be mapped.
[[nodiscard]] MappedLog map_log(LogReader& reader,
                                const std::string& name,
                                const MapLogOptions& options = {},
                                const MapLogWatcher& watcher = {});

/// A map of nothing would replace the last one: throws FileError with what is wrong with the log.
void require_something_mapped(const MappedLog& mapped);

/// What a map file keeps of it beside the map: save_map_file(mapped.map, path,
/// map_record_of(mapped)).
[[nodiscard]] MapRecord map_record_of(const MappedLog& mapped, PoseOf pose_of = PoseOf::kBase);

/// How save_map() writes it, so that the files are those of `setsquare map` with the same options.
[[nodiscard]] SaveMapOptions save_options_of(const MappedLog& mapped,
                                             PoseOf pose_of = PoseOf::kBase);

}  // namespace setsquare
