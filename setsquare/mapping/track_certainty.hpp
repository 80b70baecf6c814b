// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/map/map.hpp"

namespace setsquare {

/// How certain each scan's position is against that of the first keyframe that is connected with
/// the largest piece: the standard deviation in m along its least certain direction, by the
/// marginal covariances of the graph at up to `max_num_nodes` keyframes - the first and the last of
/// each piece at least -, interpolated over the scans of a piece. Infinite for scans of pieces that
/// were not joined; empty where there is no graph.
[[nodiscard]] std::vector<double> position_sigmas_m(const Map& track,
                                                    std::size_t max_num_nodes = 48);

/// The stretches that were degenerate all along, in their order: those of at least `min_way_m`, and
/// those whose length is not known to `min_sigma_m` - without odometry the way may not be seen.
[[nodiscard]] std::vector<OpenStretch> open_stretches(const Map& track,
                                                      double min_way_m = 1.0,
                                                      double min_sigma_m = 0.5);

/// Writes both into the map: MappedScan::position_sigma_m and Map::open_stretches.
void add_certainty(Map& map);

}  // namespace setsquare
