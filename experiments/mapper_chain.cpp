// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/mapper_chain.hpp"

#include "setsquare/mapping/mapper.hpp"
#include "setsquare/sim/sensing/odometry_model.hpp"

namespace setsquare::experiments {

Map track_by_mapper(std::span<const SimulatedScan> scans,
                    std::optional<std::uint64_t> odometry_seed) {
  std::optional<OdometryModel> wheels;
  if (odometry_seed) wheels.emplace(OdometryParams{}, *odometry_seed);
  Mapper mapper;
  for (const SimulatedScan& simulated : scans) {
    std::optional<Pose2> T_wheels_base;
    if (wheels) T_wheels_base = wheels->move_to(simulated.T_map_base);
    static_cast<void>(mapper.add(simulated.scan, T_wheels_base));
  }
  return mapper.finish();
}

}  // namespace setsquare::experiments
