// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from mapper: what it keeps of the maps that it goes on with.
#pragma once

#include <cstddef>
#include <span>

#include "setsquare/map/map.hpp"
#include "setsquare/mapping/growing_track.hpp"
#include "setsquare/mapping/mapper_params.hpp"

namespace setsquare {

/// Maps that are gone on with.
struct KnownMaps {
  GrowingTrack track;
  Map sensors;  ///< What the first one's sensors turned out to be, and nothing else.
  std::size_t num_with_odometry = 0;  ///< Scans of all.
};

/// Throws ParameterError as GrowingTrack::add() does.
[[nodiscard]] KnownMaps known_maps(std::span<const Map> maps, const MapperParams& params);

/// Writes into a map what the sensors of the first one turned out to be.
void write_sensors(const KnownMaps& known, Map& map);

}  // namespace setsquare
