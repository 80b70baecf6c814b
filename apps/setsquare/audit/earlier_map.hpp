// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from audit: the files of a map made earlier, or by another program.
#pragma once

#include <string>
#include <vector>

#include "setsquare/core/trajectory.hpp"
#include "setsquare/map/map.hpp"

namespace setsquare::app {

/// A map by its files.
struct EarlierMap {
  std::string trajectory_path;
  Trajectory trajectory;
  bool is_of_sensor = false;  ///< Its poses are those of the laser.
  /// What run.json tells; empty where there is none, or it is of another trajectory.
  std::vector<MappedScan> scans;  ///< Status and is_placed, one per pose.
  std::vector<TrackPiece> pieces;
  std::vector<OpenStretch> open_stretches;
};

/// Reads a folder of `setsquare map`, or a trajectory in the TUM format, whose poses are those of
/// the laser where `is_of_sensor` says so. Throws FileError, FormatError.
[[nodiscard]] EarlierMap read_earlier_map(const std::string& path, bool is_of_sensor);

/// Finds the poses of a log's scans, one after the other.
class PosesOfScans {
 public:
  /// `trajectory` must outlive this.
  PosesOfScans(const Trajectory& trajectory, double max_time_difference_s);

  /// The index of the pose that is nearest in time to the next scan of this stamp; of several of
  /// one stamp each is given once, in their order. Its own size where there is none.
  [[nodiscard]] std::size_t next(Timestamp stamp);

 private:
  const Trajectory& trajectory_;
  double max_time_difference_s_;
  std::vector<std::size_t> by_stamp_;  ///< Indices of the poses, the earliest first.
  std::vector<bool> is_taken_;
};

}  // namespace setsquare::app
