// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/scan/point_set.hpp"

namespace setsquare {

/// ThinOut (paper, section 4.2 and Figure 3): walks the points in order and drops each that lies
/// nearer than `min_spacing_m` to a kept one, so that density no longer depends on range.
/// The kept points stay in order. `min_spacing_m` is positive.
[[nodiscard]] PointSet thin(const PointSet& points, double min_spacing_m);

}  // namespace setsquare
