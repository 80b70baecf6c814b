// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/headings/heading_params.hpp"
#include "setsquare/headings/straight_pieces.hpp"
#include "setsquare/scan/point_set.hpp"

namespace setsquare {

/// A direction, modulo 90 deg, along and across which a scan's walls run.
struct SquareDirection {
  /// Rotation of the scan that lays the walls along the axes, in [0, pi/2). When the sensor turns
  /// by +a it grows by +a: it is the sensor's heading in the building, modulo 90 deg.
  double theta_rad = 0.0;
  double sigma_rad = 0.0;  ///< Standard deviation of theta, given that the peak is the right one.
  double sharpness = 0.0;  ///< Peak of the density of wall directions over its mean, at least 1.
  double height = 0.0;     ///< Peak of the density; compare within one scan.
};

/// The directions of a scan, highest peak first; none where nothing in it is straight.
struct SquareDirections {
  std::vector<SquareDirection> peaks;

  /// The highest peak's height over the next one's; infinite where it stands alone, 0 where there
  /// is none. Below about 2 the highest may be the wrong one (docs/method.md has the figures).
  [[nodiscard]] double margin() const;
};

/// Measures a scan's heading against the building, modulo 90 deg: (1) part the returns into
/// straight pieces; (2) the peaks of the density of their directions, modulo 90 deg, each piece
/// spread by its own uncertainty; (3) from each peak, a robust weighted mean of the pieces'
/// directions (iteratively reweighted, Geman-McClure) and of the directions from piece to piece
/// along one line: a wall that doors interrupt is a longer lever than each of its pieces.
/// `points` are the scan's returns in the order of the beams, not thinned.
[[nodiscard]] SquareDirections square_directions(const PointSet& points,
                                                 double bearing_step_rad,
                                                 const SquareDirectionParams& params = {});

}  // namespace setsquare
