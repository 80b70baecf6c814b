// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "setsquare/core/loop_closure.hpp"
#include "setsquare/core/trajectory.hpp"
#include "setsquare/drawing/image.hpp"
#include "setsquare/report/map/footer.hpp"
#include "setsquare/report/map/layout.hpp"

namespace setsquare {

/// An accepted loop closure in a map picture.
struct PlacedClosure {
  Eigen::Vector2d from_cells;  ///< Where the robot was, in cells from the grid's lower left corner.
  Eigen::Vector2d to_cells;
  double weight = 1.0;  ///< In the final graph, 0 to 1.
  bool binds_both_axes = true;
};

using PlacedClosures = std::vector<PlacedClosure>;

/// The accepted closures, each between the poses of its stamps; those whose stamps no pose has are
/// left out. `path_cells`: the places of the poses. Where poses share a stamp, the first counts.
[[nodiscard]] PlacedClosures placed_closures(std::span<const LoopClosure> closures,
                                             std::span<const StampedPose> T_map_base,
                                             std::span<const Eigen::Vector2d> path_cells);

/// Draws each as a thin line with a dot at both ends, the paler the less it weighs.
void draw_closures(Image& image, const MapLayout& layout, const PlacedClosures& closures);

/// The entries of a legend: one entry per kind present.
[[nodiscard]] std::vector<LegendEntry> legend_entries(const PlacedClosures& closures);

}  // namespace setsquare
