// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "setsquare/scan/point_set.hpp"

namespace setsquare {

/// Parameters of straight_pieces.
struct StraightPieceParams {
  double max_gap_m = 0.2;      ///< Neighbouring returns further apart may part two surfaces.
  double max_gap_beams = 8.0;  ///< Nor nearer than this many steps of the beams' fan there.
  std::int32_t max_skipped_beams = 2;  ///< Beams without a return inside a piece.
  double min_tolerance_m = 0.05;       ///< Furthest that a point may lie off its piece ...
  double max_tolerance_m = 0.15;       ///< ... in between: this many times the scan's noise.
  double tolerance_per_noise = 4.0;    ///< Noise as surface_noise_m measures it.
  std::int32_t min_num_points = 3;     ///< Of a piece.
};

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
