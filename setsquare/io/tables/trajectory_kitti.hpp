// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "setsquare/core/trajectory.hpp"

namespace setsquare {

/// The KITTI odometry format (as evo reads it): a pose per line, the upper three rows of its 4 x 4
/// matrix, row by row. It has no stamps: two files are compared line by line. Positions (m) have
/// six decimals, z is 0.
[[nodiscard]] std::string kitti_from_trajectory(const Trajectory& trajectory);

}  // namespace setsquare
