// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/paper/direction_curve.hpp"
#include "setsquare/paper/direction_moment.hpp"
#include "setsquare/scan/point_set.hpp"

namespace setsquare {

/// Parameters of Algorithm 2.
struct DominantDirectionParams {
  ProfileBins bins = {};                ///< Of the profiles; section 4.3.2.
  double step_rad = rad_from_deg(0.1);  ///< Between directions; divides half a turn.
  DirectionMoment moment = DirectionMoment::kNeighbourDifferences;  ///< Reading of eq. (7).

  /// Throws ParameterError where a field is outside its domain.
  void validate() const;
};

/// What Algorithm 2 finds.
struct DominantDirection {
  double theta_rad = -kPi;  ///< theta_D, in [-pi, 0).
  double moment = 0.0;      ///< M(theta_D), in counts squared; 0 where no point is in range.
};

/// The directions that Algorithm 2 has to try. M has period pi (the profile of theta + pi is that
/// of theta, mirrored) and the first of equal maxima wins, so half of [-pi, pi) decides.
[[nodiscard]] DirectionGrid dominant_direction_grid(const DominantDirectionParams& params);

/// GetDominantDirection of the paper, Algorithm 2: the argmax of M alone over [-pi, pi). theta_D
/// is the rotation of the scan that lays its strongest family of walls across the axis of eq. (4):
/// when the robot turns by +a, theta_D grows by +a, modulo pi.
[[nodiscard]] DominantDirection dominant_direction(const PointSet& points,
                                                   const DominantDirectionParams& params = {});

}  // namespace setsquare
