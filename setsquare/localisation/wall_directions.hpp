// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/localisation/wall_distance.hpp"
#include "setsquare/surfaces/angle_histogram.hpp"

namespace setsquare {

/// Length of a grid's walls by the direction that they face: a line is fitted to the wall cells
/// about each wall cell that borders on free space, and faces the side that is free, or both.
[[nodiscard]] AngleHistogram wall_directions(const WallDistance& walls);

}  // namespace setsquare
