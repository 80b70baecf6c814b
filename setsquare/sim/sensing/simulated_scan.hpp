// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/scan/scan.hpp"
#include "setsquare/sim/random.hpp"
#include "setsquare/sim/sensing/person.hpp"
#include "setsquare/sim/sensing/ray_casting.hpp"
#include "setsquare/sim/sensing/robot_path.hpp"
#include "setsquare/sim/sensing/scanner_model.hpp"

namespace setsquare {

/// A scan and the truth about it.
struct SimulatedScan {
  Scan scan;
  Pose2 T_map_base;  ///< At the middle of the sweep: the pose that the scan as a whole shows.
  double clutter_share = 0.0;  ///< Of its returns: furniture, clutter, people.
};

/// What a scanner on a robot sees while the robot moves along a path. Beams that return nothing are
/// written as max_range_m + 1. The people stand still during the sweep, where they are in its
/// middle. `time_s`: of the first beam, since the path's start; it becomes the scan's stamp. The
/// same state of `random` gives the same scan; every beam draws as many numbers, whatever it meets.
/// `T_base_sensor`: where the scanner is mounted, truly; the scan says so, too.
[[nodiscard]] SimulatedScan simulate_scan(const RayCaster& caster,
                                          const std::vector<Person>& people,
                                          const ScannerModel& scanner,
                                          const RobotPath& path,
                                          double time_s,
                                          Random& random,
                                          const Pose2& T_base_sensor = {});

}  // namespace setsquare
