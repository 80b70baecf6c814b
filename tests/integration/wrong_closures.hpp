// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Wrong closures among a mapper's own, as if they had passed its verification.
#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include "setsquare/graph/pose_graph.hpp"

namespace setsquare::testing {

struct WrongClosureParams {
  double share = 0.3;          ///< Of all closures, the wrong ones included.
  std::size_t group_size = 1;  ///< Neighbouring pairs that share one wrong displacement.
  double min_way_m = 20.0;     ///< Along the track, between the two places.
  double min_off_m = 0.5;      ///< How far off a wrong closure is, along an axis that it binds ...
  double max_slip_m = 5.0;     ///< ... where it is a slip; others take any two places for one.
  /// For each member of a group: squared distance from what the graph knows of the two places
  /// without it, by the covariance of both. A closure with less cannot be recognized as wrong.
  double min_squared_disagreement = 0.0;
};

/// The graph with all weights 1 and wrong closures after its own. Each is that of two keyframes
/// drawn at random and has the information of an own closure drawn at random, turned with the map's
/// axes. Half of them (of the groups) are slips of a place against itself, up to max_slip_m; the
/// others take two different places for the same one.
[[nodiscard]] PoseGraph with_wrong_closures(const PoseGraph& graph,
                                            const WrongClosureParams& params,
                                            std::mt19937_64& generator);

/// Weights 1 for all.
[[nodiscard]] PoseGraph with_full_weights(PoseGraph graph);

[[nodiscard]] std::size_t num_closures(const PoseGraph& graph);

}  // namespace setsquare::testing
