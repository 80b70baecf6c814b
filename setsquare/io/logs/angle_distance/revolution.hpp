// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// One beam of a scanner whose beams are not evenly spaced.
struct BearingRange {
  double bearing_rad = 0.0;  ///< In [-pi, pi).
  double range_m = 0.0;
};

/// Sets the beams of `scan` (bearings and ranges) to those of one revolution, evenly spaced: the
/// step is the median spacing of the bearings, and beam 0 the first behind the widest gap. A beam
/// has the smallest positive range whose bearing is nearest to it, NaN where there is none. At
/// least two different bearings are needed; false where there are fewer. Sorts `beams`.
[[nodiscard]] bool resample(std::vector<BearingRange>& beams, Scan& scan);

}  // namespace setsquare
