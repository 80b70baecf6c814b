// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from map_maker, its only caller, because tests drive it without scans.
#pragma once

#include <span>
#include <vector>

#include "setsquare/headings/fusion.hpp"
#include "setsquare/mapping/audit/audit.hpp"
#include "setsquare/mapping/mapper_params.hpp"

namespace setsquare {

/// A turn that the walls left undecided, and how far the robot turned there beyond what was
/// tracked.
struct ToldTurn {
  DoubtedTurn turn;
  double beyond_rad = 0.0;
};

/// The doubted turns that explain how hypotheses contradict the headings: those across which they
/// have the robot turned by as much more, or less, as the walls turned there. Three at most, those
/// first that explain most of the hypotheses.
[[nodiscard]] std::vector<ToldTurn> told_turns(const FusedHeadings& headings,
                                               std::span<const MapHypothesis> hypotheses,
                                               const TurnCheckParams& params);

}  // namespace setsquare
