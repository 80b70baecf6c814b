// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "apps/setsquare/simulate/options.hpp"
#include "setsquare/core/trajectory.hpp"
#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/sensing/robot_path.hpp"

namespace setsquare::app {

/// A run through a world.
struct SimulatedRun {
  std::string log;             ///< CARMEN: a TRUEPOS before each ROBOTLASER1.
  Trajectory truth;            ///< Of the base, one pose a scan, at the scan's stamp.
  Trajectory odometry;         ///< What the wheels say, likewise.
  double clutter_share = 0.0;  ///< Mean over the scans: furniture, clutter, people.
  std::size_t num_beams = 0;   ///< Of the first scan.
  double duration_s = 0.0;
  double length_m = 0.0;
};

/// Drives the route of the world and scans; shows how far it is. Stamps count from the start, in
/// whole microseconds. Throws ParameterError, Error (more than a million scans, a route through a
/// wall of a plan, a rate that the scanner cannot hold).
[[nodiscard]] SimulatedRun run_simulation(const Building& world, const SimulateOptions& options);

}  // namespace setsquare::app
