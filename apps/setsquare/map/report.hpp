// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "apps/setsquare/map/run.hpp"
#include "setsquare/core/trajectory.hpp"

namespace setsquare::app {

/// Consecutive scans of one status other than "tracked".
struct Stretch {
  TrackStatus status = TrackStatus::kTracked;
  std::size_t first_scan = 0;
  std::size_t num_scans = 0;
  double path_m = 0.0;  ///< Travelled meanwhile.
};

/// The stretches of a track, in its order.
[[nodiscard]] std::vector<Stretch> stretches(const MappedTrack& track);

/// The loop closures of a track, counted.
struct ClosureCounts {
  std::size_t num_compared = 0;
  std::size_t num_accepted = 0;
  std::size_t num_one_axis = 0;  ///< Of the accepted.
  std::size_t num_outvoted = 0;  ///< Of the accepted: weight below one half in the final graph.
};

[[nodiscard]] ClosureCounts count_closures(const MappedTrack& track);

/// "tracked", "degenerate", "recovered", "lost".
[[nodiscard]] const char* to_string(TrackStatus status);

/// The poses that trajectory.tum holds, one per scan, in the log's order.
[[nodiscard]] Trajectory trajectory_from(const MappedTrack& track, bool is_of_sensor);

/// Travelled along the trajectory, in m.
[[nodiscard]] double path_length_m(const MappedTrack& track);

/// The content of run.json: what was read, how it went, with which options and parameters. The
/// same log and options give the same bytes; times are in timing.json.
[[nodiscard]] std::string run_json(const MapOptions& options, const MapRun& run);

}  // namespace setsquare::app
