// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Olson (olson2008), "Robust and Efficient Robotic Mapping": a place is known again if it is
// unambiguous over a larger extent than its position's spread.
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "setsquare/mapping/audit/audit.hpp"

namespace setsquare {

/// Covariance of the way between two keyframes of a track, in the map frame, in m^2.
using WaySpread = std::function<Eigen::Matrix2d(std::size_t, std::size_t)>;

/// Which of the matches (indices) close loops that the map leaves open.
///
/// 1. Those that the map does not contradict, but does not know either: off by no more than the
///    spread of the way between their keyframes, the headings as in the map.
/// 2. Groups of them that tell the same of the same two parts of the track, several independent
///    ones each. One whose later places were matched elsewhere, too, is ambiguous and left out.
/// 3. Groups that can all be right, for all that is known of the ways between them.
/// 4. Believed if no alias explains them. A twin of what they tell would lie beside it, so farther
///    off than it extends. Where that is more than the position can be off besides the correction
///    that it asks for, along either axis of the spread, there is no twin. The more rooms tell it
///    that are told apart from each other, the less likely is a twin, and the less it takes.
[[nodiscard]] std::vector<std::size_t> believed_closures(std::span<const AuditMatch> matches,
                                                         const AuditedTrack& track,
                                                         const WaySpread& spread,
                                                         const ClosuresAnywhereParams& params,
                                                         const AuditParams& audit);

/// Closures that need no belief in the estimate, for tracks with stretches along which the walls
/// left a direction open: behind them loops lie anywhere within the spread. Places alike by
/// signature are matched without a guess, and more about those that match; what is believed comes
/// back. Nothing where the map knows its ways. `surfaces`: one per keyframe of the map. Any number
/// of threads gives the same. Throws ParameterError.
[[nodiscard]] std::vector<MapHypothesis> closures_anywhere(
    const Map& map,
    std::span<const ScanSurfacesPtr> surfaces,
    const ClosuresAnywhereParams& params,
    const AuditParams& audit,
    std::size_t num_threads);

/// Whether a map that was closed by hypotheses has their keyframes where they tell, but for a few.
[[nodiscard]] bool has_kept(const Map& map,
                            std::span<const MapHypothesis> hypotheses,
                            const ClosuresAnywhereParams& params,
                            const AuditParams& audit);

}  // namespace setsquare
