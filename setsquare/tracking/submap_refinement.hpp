// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "setsquare/tracking/open_direction.hpp"
#include "setsquare/tracking/open_turn.hpp"
#include "setsquare/tracking/scan_tracker_params.hpp"
#include "setsquare/tracking/submap_alignment.hpp"

namespace setsquare {
/// What a scan is compared with: the submap, and the memory that comparisons reuse.
struct TrackingProblem {
  std::span<const PlacedImage> submap;  ///< In the odom frame.
  const SurfaceSamples& points;
  Pose2 T_odom_predicted;  ///< Where the scan is expected ...
  PredictionTrust trust;   ///< ... and how far that is trusted.
  PointMarks& marks;
};

/// A scan placed in its submap.
struct SubmapFit {
  Pose2 T_odom_sensor;
  SubmapAlignment alignment;  ///< Where the last step began; without the prediction's share.
  OpenDirection open;         ///< Of that alignment, in the odom frame.
  OpenTurn turn;              ///< The same; bound where a direction is open.
};

/// Gauss-Newton, point to line, from `start`: wide gate first, narrow gate after. Where fewer than
/// min_effective_points bind the position along some direction, the prediction makes up for the
/// missing ones, along that direction only. Where only noise binds a turn, it is the prediction's.
[[nodiscard]] SubmapFit refine_in_submap(const TrackingProblem& problem,
                                         const Pose2& start,
                                         const SubmapRefinementParams& params);

/// Looks along the open direction of `fit` for a better place. In a corridor the distances to the
/// two walls have no gradient along it; the evidence is how many points fit at all (door frames,
/// recesses, the far end), and that has many small maxima. So a window about the prediction is
/// tried step by step, its best place refined, and kept if it is closer than `fit`'s.
[[nodiscard]] SubmapFit search_along_corridor(const TrackingProblem& problem,
                                              const SubmapFit& fit,
                                              const CorridorSearchParams& params,
                                              const SubmapRefinementParams& refinement);

}  // namespace setsquare
