// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Graduated non-convexity: Yang et al. 2020, "Graduated Non-Convexity for Robust Spatial
// Perception", IEEE RA-L 5.
#pragma once

#include <cstddef>
#include <span>

#include "setsquare/graph/pose_graph.hpp"

namespace setsquare {

struct RobustPoseGraphParams {
  /// Squared error beyond which a closure that binds both axes is taken for wrong ...
  double max_squared_error = 16.0;
  double divide_mu_by = 1.4;  ///< Step of the graduation.
  int max_iterations = 60;

  /// Throws ParameterError that names the field.
  void validate() const;
};

/// Weights of the loop closures and positions of the nodes, headings as they are: truncated least
/// squares by graduated non-convexity, started from full weights (a warm start rejects the right
/// closure after a long loop), each step one linear solve (solve_positions).
/// `groups`: one entry a constraint; closures of one group stand or fall together, by their mean
/// squared error; empty: each stands alone. Odometry constraints keep their weight.
void solve_robustly(PoseGraph& graph,
                    std::span<const std::size_t> groups = {},
                    const RobustPoseGraphParams& params = {});

}  // namespace setsquare
