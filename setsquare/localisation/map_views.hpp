// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/grid/placed_scan.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {

/// What a scan of the map's own saw where it was taken.
struct MapView {
  Pose2 T_grid_sensor;  ///< Of its sensor, in the frame of the grid.
  SurfaceImage image;   ///< Its surfaces.
  SurfaceSamples fine;  ///< Its samples, as PreparedScan::fine.
};

/// The views of a map, each made when it is first asked for, and kept: a map that is never in doubt
/// costs nothing. Any number of threads may ask. What was copied or moved shares its views.
class MapViews {
 public:
  /// A scan that the views share until its view is made.
  struct SharedScan {
    std::shared_ptr<const Scan> scan;  ///< Not null.
    Pose2 T_map_sensor;                ///< Where its sensor was in the map frame.
  };

  /// None.
  MapViews() = default;
  /// In the frame of a grid. Throws ParameterError where a scan's geometry is not valid.
  MapViews(std::span<const SharedScan> scans, const Pose2& T_map_grid);

  /// How many, made or not.
  [[nodiscard]] std::size_t size() const;
  /// Whether there are none.
  [[nodiscard]] bool empty() const { return size() == 0; }
  /// MapView::T_grid_sensor, for which no view is made.
  [[nodiscard]] const Pose2& T_grid_sensor(std::size_t i) const;
  /// The view, which is made now where it was not yet.
  [[nodiscard]] const MapView& operator[](std::size_t i) const;
  /// Views that were made so far.
  [[nodiscard]] std::size_t num_made() const;

 private:
  struct Slot;
  std::shared_ptr<std::vector<Slot>> slots_;
};

/// How a scan at a place falls on what the views about the place saw. All views together: a piece
/// of wall that one of them saw is seen, and one through which one looked, and that none saw, is
/// not there.
struct SeenByViews {
  std::size_t num_views = 0;  ///< That looked there; 0: the views tell nothing of the place.
  double wall_m = 0.0;        ///< Of the scan.
  double tight_m = 0.0;       ///< Of it on a wall of some view to 4 cm, facing the same way ...
  double loose_m = 0.0;       ///< ... and to 15 cm.
  double through_m = 0.0;     ///< On none, and some view looked through it.
  double behind_m = 0.0;      ///< On none, through none, behind what some view saw.
  double outside_m = 0.0;     ///< Where none looked.
  double distance_m = 0.0;    ///< Of what is loose from its wall (root of the mean square).
  // Of the walls of the views that agree most, per view:
  double missed_m = 0.0;       ///< The scan looked through them.
  double unexplained_m = 0.0;  ///< They lie behind something that is not on a wall of the view.
};

/// Lays the scan onto the views about the place, at most the 80 nearest, and compares.
[[nodiscard]] SeenByViews seen_by_views(const MapViews& views,
                                        const PreparedScan& scan,
                                        const Pose2& T_grid_sensor);

}  // namespace setsquare
