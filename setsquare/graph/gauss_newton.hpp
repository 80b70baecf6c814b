// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/graph/pose_graph.hpp"

namespace setsquare {

struct GaussNewtonParams {
  int max_iterations = 10;
  double converged_m = 1e-4;    ///< Largest step of any node below this ...
  double converged_rad = 1e-5;  ///< ... and this ends the iteration.

  /// Throws ParameterError that names the field.
  void validate() const;
};

struct GaussNewtonSummary {
  int num_iterations = 0;
  double initial_cost = 0.0;  ///< Half the sum of weighted squared errors.
  double final_cost = 0.0;
};

/// Polishes all poses at once, headings included: Gauss-Newton on SE(2) over the constraints, by
/// their weights, and the heading measurements. Needs a good start (solve_positions). Node 0's
/// position stays; its heading, too, unless there are heading measurements. A step that does not
/// lower the cost is halved, and given up after a few halvings.
GaussNewtonSummary polish(PoseGraph& graph, const GaussNewtonParams& params = {});

}  // namespace setsquare
