// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The data that submap_matcher compares; piece joining makes them, too.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "setsquare/mapping/keyframe_track.hpp"
#include "setsquare/surfaces/correlation_grid.hpp"
#include "setsquare/surfaces/surface_samples.hpp"

namespace setsquare {

/// Neighbouring keyframes as one wide view, in the frame of the sensor of the one in the middle.
/// It looks into keyframes that must outlive it.
struct Submap {
  std::size_t keyframe = 0;  ///< The one in the middle, among all keyframes.
  std::vector<const Keyframe*> members;
  std::size_t middle_member = 0;    ///< `keyframe` among the members.
  std::vector<PlacedImage> images;  ///< Of the members.
  SurfaceSamples coarse;            ///< A few dozen, rare directions favoured: proposals.
  SurfaceSamples rough;             ///< A hundred or so, likewise: refinement from afar.
  SurfaceSamples fine;              ///< A few hundred, likewise: the verdict.
};

/// The keyframe at `middle` and up to `half_width` of its stretch of track to either side, placed
/// by `T_map_sensor` (one per keyframe).
[[nodiscard]] Submap make_submap(const KeyframeTrack& track,
                                 std::span<const Pose2> T_map_sensor,
                                 std::size_t middle,
                                 std::size_t half_width);

/// The surfaces of the whole submap, and the free space that its middle keyframe saw.
[[nodiscard]] CorrelationGrid correlation_grid(const Submap& submap);

}  // namespace setsquare
