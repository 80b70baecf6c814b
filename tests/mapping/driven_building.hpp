// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A drive through a made-up building, with the truth.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/sensing/ray_casting.hpp"
#include "setsquare/sim/sensing/robot_path.hpp"
#include "setsquare/sim/sensing/scanner_model.hpp"
#include "setsquare/sim/sensing/simulated_scan.hpp"

namespace setsquare {

struct DrivenBuilding {
  std::vector<Scan> scans;
  std::vector<Pose2> T_map_sensor;
};

/// So many scans per second through a building.
inline DrivenBuilding driven_building(BuildingClass building_class,
                                      std::uint64_t seed,
                                      double rate_hz = 2.0) {
  const Building building = make_building(building_class, seed);
  const RobotPath path(building.route_m);
  const RayCaster caster(building.plan);
  const ScannerModel scanner = utm_30lx();
  DrivenBuilding drive;
  const auto num_scans = static_cast<std::size_t>(path.duration_s() * rate_hz);
  for (std::size_t i = 0; i < num_scans; ++i) {
    Random random(sub_seed(seed, i));
    SimulatedScan simulated = simulate_scan(
        caster, building.people, scanner, path, static_cast<double>(i) / rate_hz, random);
    drive.T_map_sensor.push_back(simulated.T_map_base * simulated.scan.T_base_sensor);
    drive.scans.push_back(std::move(simulated.scan));
  }
  return drive;
}

}  // namespace setsquare
