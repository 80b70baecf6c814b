// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "setsquare/grid/grid_from_scans.hpp"

namespace setsquare {

/// The direction of the building's walls in the map frame, in [-pi/4, pi/4), from the returns of
/// all the scans together: grid_from_scans with this heading gives a grid whose rows run along the
/// walls. It is the direction at which M(theta) + M(theta + 90 deg) of eq. (7) is greatest. 0 where
/// there is no return.
[[nodiscard]] double building_heading_rad(std::span<const PlacedScan> scans);

}  // namespace setsquare
