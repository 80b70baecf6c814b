// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// With headings known, a pose graph is linear in the positions (as in LAGO: Carlone et al. 2014).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "setsquare/graph/pose_graph.hpp"

namespace setsquare {

/// The positions of all nodes that minimise the constraints' weighted squared errors while the
/// headings stay as they are: one sparse linear solve, no initial value. A constraint whose
/// rotation disagrees with the headings pulls its translation along by its information
/// (off-diagonal terms). Node 0 stays. Where no constraint couples x with y in the map frame the
/// two axes are solved apart. Every node must hang on node 0 by constraints that bind both axes;
/// throws ParameterError where one does not.
[[nodiscard]] std::vector<Eigen::Vector2d> solve_positions(const PoseGraph& graph);

}  // namespace setsquare
