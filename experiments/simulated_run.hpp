// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/sensing/ray_casting.hpp"
#include "setsquare/sim/sensing/robot_path.hpp"
#include "setsquare/sim/sensing/scanner_model.hpp"
#include "setsquare/sim/sensing/simulated_scan.hpp"

namespace setsquare::experiments {

/// The scanner, the robot's motion, and the people in the building.
struct RunParams {
  ScannerModel scanner = utm_30lx();
  RobotSpeed speed = {};
  bool has_people = true;
};

/// A building and what a robot saw on its way through it.
struct SimulatedRun {
  RayCaster caster;
  std::vector<SimulatedScan> scans;
};

/// Simulates scans at these times of the path. The noise of a scan depends on the seed and on its
/// place in `times` alone.
[[nodiscard]] SimulatedRun simulate_run(const Building& building,
                                        const RobotPath& path,
                                        std::span<const double> times_s,
                                        const RunParams& params,
                                        std::uint64_t seed);

/// A seeded building of a class and about 16 scans of it, as study_times places them.
[[nodiscard]] SimulatedRun simulate_study_run(BuildingClass building_class,
                                              std::uint64_t seed,
                                              const RunParams& params);

/// Pose of the current scan's base in the reference's, by the truth.
[[nodiscard]] Pose2 true_relative_pose(const SimulatedScan& reference,
                                       const SimulatedScan& current);

}  // namespace setsquare::experiments
