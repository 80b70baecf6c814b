// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "setsquare/slam/scan_tracker_params.hpp"
#include "setsquare/slam/submap_alignment.hpp"
#include "setsquare/slam/weak_direction.hpp"

namespace setsquare {

/// What a scan is compared with: the submap, and the memory that comparisons reuse.
struct TrackingProblem {
  std::span<const PlacedImage> submap;  ///< In the odom frame.
  const SurfaceSamples& points;
  Pose2 T_odom_predicted;  ///< Where the scan is expected ...
  PredictionTrust trust;   ///< ... and how far that is believed.
  PointMarks& marks;
};

/// A scan placed in its submap.
struct SubmapFit {
  Pose2 T_odom_sensor;
  SubmapAlignment alignment;  ///< Where the last step began; without the prediction's share.
  WeakDirection weak;         ///< Of that alignment, in the odom frame.
};

/// Gauss-Newton, point to line, from `start`: wide gate first, narrow gate after. Where fewer than
/// min_effective_points bind the position along some direction, the prediction makes up for the
/// missing ones, along that direction only.
[[nodiscard]] SubmapFit refine_in_submap(const TrackingProblem& problem,
                                         const Pose2& start,
                                         const SubmapRefinementParams& params);

}  // namespace setsquare
