// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/scan/point_set.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// The returns of a scan (and nothing else) as points of the sensor frame, in the order of the
/// beams: eqs. (1)-(3) of the paper, for any field of view and either rotation sense.
[[nodiscard]] PointSet points_from_scan(const Scan& scan);

}  // namespace setsquare
