// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "apps/setsquare/map/timing.hpp"
#include "apps/setsquare/preset.hpp"
#include "setsquare/io/logs/log_reader.hpp"
#include "setsquare/mapping/mapped_track.hpp"
#include "setsquare/mapping/track_certainty.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare::app {

/// What `setsquare map` was asked to do.
struct MapOptions {
  std::string log_path;
  std::string output_path;  ///< A directory; made if it is not there.
  LogOptions log;
  Preset preset = Preset::kDefault;
  bool uses_odometry = true;
  bool is_of_sensor = false;  ///< Poses of the sensor instead of the robot's.
  std::size_t num_threads = 1;
};

/// A scan that the picture needs.
struct PictureScan {
  Scan scan;
  std::size_t index = 0;  ///< Among the log's scans, from 0.
};

/// A log mapped.
struct MapRun {
  MappedTrack track;
  std::vector<OpenStretch> open_stretches;  ///< Of the track; see track_certainty.hpp.
  std::vector<PictureScan> picture_scans;   ///< Keyframes, and those that moved on.
  std::size_t num_with_odometry = 0;        ///< Scans whose odometry was used.
  std::string format;
  std::string sensor;
  LogProblems problems;
};

/// Reads the opened log to its end, scan by scan, and maps it; shows how far it is; `clock`
/// receives the stages. Throws FileError, FormatError, ParameterError.
[[nodiscard]] MapRun run_map(LogReader& reader, const MapOptions& options, StageClock& clock);

}  // namespace setsquare::app
