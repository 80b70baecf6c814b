// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/slam/submap_refinement.hpp"

namespace setsquare {

/// Looks along the weak direction of `fit` for a better place. In a corridor the distances to the
/// two walls have no gradient along it; what tells is how many points fit at all (door frames,
/// recesses, the far end), and that has many small maxima. So a window about the prediction is
/// tried step by step, its best place refined, and kept if it is closer than `fit`'s.
[[nodiscard]] SubmapFit search_along_corridor(const TrackingProblem& problem,
                                              const SubmapFit& fit,
                                              const CorridorSearchParams& params,
                                              const SubmapRefinementParams& refinement);

}  // namespace setsquare
