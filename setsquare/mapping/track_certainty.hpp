// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/mapping/mapped_track.hpp"

namespace setsquare {

/// How certain each scan's position is against that of the first keyframe that hangs together with
/// the largest piece: the standard deviation in m along its least certain direction, by the
/// marginal covariances of the graph at up to `max_num_nodes` keyframes - the first and the last of
/// each piece at least -, interpolated over the scans of a piece. Infinite for scans of pieces that
/// were not joined; empty where there is no graph.
[[nodiscard]] std::vector<double> position_sigmas_m(const MappedTrack& track,
                                                    std::size_t max_num_nodes = 48);

/// A stretch along which the scans left one direction open: a bare corridor.
struct OpenStretch {
  std::size_t first_scan = 0;
  std::size_t num_scans = 0;
  double way_m = 0.0;          ///< Travelled meanwhile, as far as is known.
  double direction_rad = 0.0;  ///< The open direction in the map frame, modulo pi.
  bool has_odometry = false;   ///< Whether odometry stood in all along.
  /// Standard deviation of its length, given everything: odometry and closures may have told it.
  double length_sigma_m = 0.0;
};

/// The stretches of at least `min_way_m` that were degenerate all along, in their order.
[[nodiscard]] std::vector<OpenStretch> open_stretches(const MappedTrack& track,
                                                      double min_way_m = 1.0);

}  // namespace setsquare
