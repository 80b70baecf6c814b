// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "setsquare/eval/closure_judgement.hpp"
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
  std::size_t num_relations = 0;     ///< Long enough to be checked.
  std::size_t num_chained = 0;       ///< That the others chain to.
  std::size_t num_off = 0;           ///< Off by more than the limits: a right closure judged wrong.
  std::size_t num_off_disputed = 0;  ///< Of those, disputed by a chain that shares no pair.
  std::size_t num_disputed = 0;      ///< Disputed in all.
  ErrorStatistics translation_m;
  ErrorStatistics rotation_rad;
};

/// Leaves out each relation in turn (and all others between the same two stamps), and judges it by
/// the chains of the rest as if it were a closure. It shows how far the judge of closures is to be
/// believed.
[[nodiscard]] ChainCheck check_chains(std::span<const Relation> relations,
                                      const ChainCheckParams& params = {});

}  // namespace setsquare
