// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A log followed in a known map: what the command and the Python package do.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "setsquare/core/trajectory.hpp"
#include "setsquare/io/logs/log_reader.hpp"
#include "setsquare/localisation/known_map.hpp"
#include "setsquare/localisation/localizer.hpp"
#include "setsquare/pipeline/map_log.hpp"

namespace setsquare {

/// A map to find scans in.
struct MapToLocaliseIn {
  OccupancyGrid grid;                     ///< To be shown.
  std::shared_ptr<const KnownMap> known;  ///< Never null.
};

/// By a grid alone.
[[nodiscard]] MapToLocaliseIn map_to_localise_in(OccupancyGrid grid);

/// Of a map file or the folder that `setsquare map` wrote, with the map's own scans
/// (KnownMap::views); or the map.yaml of any program (map_server, nav2), by its grid alone. Throws
/// FileError, FormatError.
[[nodiscard]] MapToLocaliseIn read_map_to_localise_in(const std::string& path);

/// How a log is followed.
struct LocalizeLogOptions {
  LogOptions log;                         ///< Which scans, and how they are read.
  bool uses_odometry = true;              ///< Where the log has it.
  std::optional<Pose2> T_map_base_start;  ///< Where the robot starts, if that is known.
  LocalisationParams localisation;        ///< Every default works.
};

/// How many scans ended in each status.
struct LocalisationCounts {
  std::size_t num_localised = 0;               ///< LocalisationStatus::kLocalised.
  std::size_t num_ambiguous = 0;               ///< LocalisationStatus::kAmbiguous.
  std::size_t num_lost = 0;                    ///< LocalisationStatus::kLost.
  std::size_t num_confirmed = 0;               ///< Compared with the map, and agreeing.
  std::optional<std::size_t> first_localised;  ///< Index of the scan.

  /// All of them.
  [[nodiscard]] std::size_t num_scans() const { return num_localised + num_ambiguous + num_lost; }
};
/// A log followed in a map.
struct LocalizedLog {
  std::vector<LocalisedPose> poses;  ///< One per scan, in the order of the log.
  /// Of the scans before these, the oldest, whose poses are left out: live localisation may go on
  /// for ever. None of a log that is read.
  LocalisationCounts left_out;
  std::string name;      ///< Of the log.
  std::string format;    ///< Of the log: "CARMEN log", ...
  std::string sensor;    ///< The scanner's name in the log.
  LogProblems problems;  ///< What was wrong with the log.
};

/// Counts one more scan.
void count(const LocalisedPose& pose, LocalisationCounts& counts);
/// Counted over all scans, those left out, too.
[[nodiscard]] LocalisationCounts counts_of(const LocalizedLog& log);

/// Poses of the scans that were localised, but for those left out.
[[nodiscard]] Trajectory trajectory_of(const LocalizedLog& log, PoseOf pose_of = PoseOf::kBase);

/// Throws ParameterError where a map has no walls or no free space.
void require_something_to_find(const KnownMap& map);

/// Writes what was read of a log: its format, sensor and problems.
void tell_log(const LogReader& reader, const LocalizeLogOptions& options, LocalizedLog& log);

/// Reads the opened log to its end and follows its front scanner (or LogOptions::sensor) in the
/// map. Throws FileError, FormatError, ParameterError; FileError, too, where it has no scan.
[[nodiscard]] LocalizedLog localize_log(LogReader& reader,
                                        const std::string& name,
                                        std::shared_ptr<const KnownMap> map,
                                        const LocalizeLogOptions& options = {},
                                        const MapLogWatcher& watcher = {});

}  // namespace setsquare
