// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/sim/random.hpp"
#include "setsquare/sim/sensing/robot_path.hpp"

namespace setsquare {

/// The times of the scans that a study of pairs takes along a path, ascending. Places every 0.4 m
/// or 10 deg as in the paper (section 5.1), from a random one on; of these every fifth to every
/// tenth, at random, so that neighbours are up to 4 m or 100 deg apart: half of the pairs within 5
/// m of each other overlap by less than 60 %. Evenly over the path where it is too short for
/// that, and fewer than `num_scans` only where it has fewer such places. `num_scans` is at least 2.
[[nodiscard]] std::vector<double> study_times(const RobotPath& path,
                                              std::size_t num_scans,
                                              Random& random);

}  // namespace setsquare
