// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "setsquare/eval/closure_summary.hpp"
#include "setsquare/eval/error_statistics.hpp"
#include "setsquare/eval/relation_graph.hpp"

namespace setsquare {

struct ChainCheckParams {
  double min_time_s = 60.0;  ///< Relations between stamps less far apart are not checked.
  ClosureLimits limits;
  RelationGraphParams graph;
};

/// How well chains of relations foretell relations that are not in them.
struct ChainCheck {
  std::size_t num_relations = 0;  ///< Long enough to be checked.
  /// As closures; unjudged are those that the others do not chain to. A right relation that comes
  /// out wrong is the judge's fault.
  ClosureCounts verdicts;
  ErrorStatistics translation_m;  ///< Of the cheapest chains.
  ErrorStatistics rotation_rad;
};

/// Leaves out each relation in turn (and all others between the same two stamps), and judges it by
/// the chains of the rest as if it were a closure. It shows how far the judge of closures is to be
/// believed.
[[nodiscard]] ChainCheck check_chains(std::span<const Relation> relations,
                                      const ChainCheckParams& params = {});

}  // namespace setsquare
