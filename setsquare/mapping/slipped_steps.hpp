// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Where tracking slipped without noticing, and how a graph takes that up.
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/graph/pose_graph.hpp"
#include "setsquare/mapping/audit/audit.hpp"

namespace setsquare {

/// Steps of the track over which it slipped: those to the keyframes behind `first`, up to `last`.
struct SlippedSteps {
  std::size_t first = 0;      ///< Of Map::keyframes.
  std::size_t last = 0;       ///< Likewise.
  double times_variance = 1;  ///< By which the steps' covariances are too small; at least 1.
};

/// Those that one audit of a map found.
using Slips = std::vector<SlippedSteps>;

/// What contradicts a map alike, each group as a slip: tracking went wrong by the correction that
/// the group asks for, somewhere between the earlier part and the later one. The steps between are
/// then too sure of themselves by one factor: that under which the correction is one standard
/// deviation of them all together. Closures between them say where it was. Groups that raise no
/// doubt, may be of twins, or ask for a turn are left out.
/// `graph`: of the map, whose first constraints are the tracked steps in their order.
[[nodiscard]] Slips slipped_steps(const AuditFindings& findings, const PoseGraph& graph);

/// Makes the steps that much more uncertain than the graph has them; one in several of the slips as
/// the greatest of them says.
/// `graph`: its first constraints are the tracked steps in their order.
void loosen_slipped(const Slips& slips, PoseGraph& graph);

}  // namespace setsquare
