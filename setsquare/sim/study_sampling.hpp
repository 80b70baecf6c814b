// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "setsquare/sim/random.hpp"
#include "setsquare/sim/robot_path.hpp"

namespace setsquare {

/// The times of the scans that a study of pairs takes along a path, ascending. Places every 0.4 m
/// or 10 deg as in the paper (section 5.1), from a random one on; of these every second to every
/// fifth, at random, so that neighbours are about 1 to 2 m or 20 to 50 deg apart. Fewer than
/// `num_scans` only where the path has fewer such places.
[[nodiscard]] std::vector<double> study_times(const RobotPath& path,
                                              std::size_t num_scans,
                                              Random& random);

}  // namespace setsquare
