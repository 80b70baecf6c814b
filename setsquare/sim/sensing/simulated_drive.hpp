// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/pose2.hpp"
#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/sensing/ray_casting.hpp"
#include "setsquare/sim/sensing/robot_path.hpp"
#include "setsquare/sim/sensing/scanner_model.hpp"
#include "setsquare/sim/sensing/simulated_scan.hpp"

namespace setsquare {

/// How a robot drives through a building and scans it.
struct SimulatedDriveParams {
  std::uint64_t seed = 1;  ///< Of the noise and the odometry, apart from that of the building.
  ScannerModel scanner = utm_30lx();  ///< Each of its scanners is one of these.
  std::vector<Pose2> T_base_sensor;   ///< Of each scanner, as the log says; none: one at the base.
  Pose2 T_stated_true;                ///< The last one's true mounting, seen from the stated one.
  RobotSpeed speed;
  TurnAtStart turn_at_start;
  double scans_per_s = 10.0;
  std::optional<double> every_m;  ///< Instead of a rate: a scan after this way or every_rad.
  double every_rad = rad_from_deg(10.0);
  bool has_drift = true;  ///< Else the wheels measure the truth.
};

/// A scan of the drive, with what the wheels say.
struct DrivenScan {
  SimulatedScan simulated;
  Pose2 T_odom_base;
};

/// Drives along the path and scans, and hands each scan to `on_scan` with the share of the drive
/// that lies behind it. Several scanners take turns: at a rate, evenly over its period, else one
/// sweep after the other. Stamps count from the start, in whole microseconds. Throws ParameterError
/// (a rate that the scanner cannot hold, more than a million scans), and what `on_scan` throws.
void simulate_drive(
    const RayCaster& caster,
    const std::vector<Person>& people,
    const RobotPath& path,
    const SimulatedDriveParams& params,
    const std::function<void(const DrivenScan& scan, double share_driven)>& on_scan);

}  // namespace setsquare
