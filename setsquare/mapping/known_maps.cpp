// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/known_maps.hpp"

namespace setsquare {
namespace {

void copy_sensors(const Map& from, Map& to) {
  to.scanners = from.scanners;
  to.gyro = from.gyro;
  to.odometry = from.odometry;
  to.sweep = from.sweep;
}

}  // namespace

KnownMaps known_maps(std::span<const Map> maps, const MapperParams& params) {
  KnownMaps known{.track = GrowingTrack(params), .sensors = {}};
  for (const Map& map : maps) {
    known.track.add(map);
    known.num_with_odometry += map.num_with_odometry;
  }
  if (!maps.empty()) copy_sensors(maps.front(), known.sensors);
  return known;
}

void write_sensors(const KnownMaps& known, Map& map) {
  copy_sensors(known.sensors, map);
  map.num_with_odometry = known.num_with_odometry;
}

}  // namespace setsquare
