// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/map/map.hpp"

namespace setsquare {

/// A map in figures: what the command prints, run.json and the page hold.
struct MapSummary {
  std::size_t num_scans = 0;            ///< Mapped, placed or not.
  std::size_t num_keyframes = 0;        ///< Kept to match with.
  std::size_t num_forgotten = 0;        ///< Keyframes that showed nothing new.
  std::size_t num_forgotten_poses = 0;  ///< Scans beside num_scans that are left out.
  std::size_t num_tracked = 0;          ///< Scans of each status.
  std::size_t num_degenerate = 0;       ///< The walls left a direction open.
  std::size_t num_recovered = 0;        ///< Found again after they were lost.
  std::size_t num_lost = 0;             ///< Not found: they stand where they were expected.
  double path_m = 0.0;  ///< Travelled along the trajectory, from one placed scan to the next, and
                        ///< where scans are left out.

  std::size_t num_compared_closures = 0;  ///< Of placed scans, as all that follow.
  std::size_t num_accepted_closures = 0;  ///< That entered the pose graph.
  std::size_t num_one_axis_closures = 0;  ///< Of the accepted.
  std::size_t num_outvoted_closures = 0;  ///< Of the accepted: final weight below one half.

  std::size_t num_unjoined_pieces = 0;  ///< Pieces of track without a place in the map.
  std::size_t num_unjoined_scans = 0;   ///< Scans in those pieces.
  double open_m = 0.0;                  ///< Travelled along open stretches, as far as is known, ...
  double open_s = 0.0;                  ///< ... in this time.
  double worst_length_sigma_m = 0.0;    ///< Of the least certain open stretch.
  std::vector<OpenStretch> open_headings;  ///< Those whose turn is open, by more than is usual.
};

/// Counts and sums of a map.
[[nodiscard]] MapSummary summary_of(const Map& map);

/// Consecutive scans of one status other than kTracked.
struct StatusStretch {
  TrackStatus status = TrackStatus::kTracked;  ///< Other than kTracked.
  std::size_t first_scan = 0;                  ///< Index of Map::scans.
  std::size_t num_scans = 0;                   ///< One after the other.
  double path_m = 0.0;                         ///< Travelled meanwhile.
};

/// The stretches of a map, in its order.
[[nodiscard]] std::vector<StatusStretch> status_stretches(const Map& map);

}  // namespace setsquare
