// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "setsquare/headings/heading_params.hpp"
#include "setsquare/scan/point_set.hpp"

namespace setsquare {

/// A run of neighbouring returns on one straight line, fitted by total least squares.
struct StraightPiece {
  double direction_rad = 0.0;  ///< Of the line, in the sensor frame, modulo pi.
  double length_m = 0.0;       ///< Of an evenly filled piece of the same spread.
  double spread_m2 = 0.0;      ///< Sum of the squared coordinates along the line.
  double rms_m = 0.0;          ///< Of the distances from the line.
  double center_x_m = 0.0;
  double center_y_m = 0.0;
};

/// Noise across the surfaces, in m: from the median distance of returns to the line through their
/// two neighbours. 0 where fewer than ten returns have neighbours within 2.5 `max_gap_m`.
[[nodiscard]] double surface_noise_m(const PointSet& points, double max_gap_m);

/// Parts the returns of a scan, in the order of the beams and not thinned, at gaps, then each run
/// at its point furthest off the chord until none is further than the tolerance, and fits a line
/// to each piece. `bearing_step_rad` is the scan's.
[[nodiscard]] std::vector<StraightPiece> straight_pieces(const PointSet& points,
                                                         double bearing_step_rad,
                                                         const StraightPieceParams& params = {});

}  // namespace setsquare
