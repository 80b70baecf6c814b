// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/mapper.hpp"

#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/mapping/growing_map.hpp"
#include "setsquare/mapping/log_tracker.hpp"
#include "setsquare/mapping/mapper_params.hpp"

namespace setsquare {

class Mapper::Parts {
 public:
  explicit Parts(const MapperParams& params) : tracker(params), map(params) {}

  LogTracker tracker;
  GrowingMap map;
  TrackSteps steps;  ///< Memory that is used again.
};

Mapper::Mapper() : Mapper(MapperParams{}) {}
Mapper::Mapper(const MapperParams& params) : parts_(std::make_unique<Parts>(params)) {}
Mapper::Mapper(const Map& map, const MapperParams& params) : Mapper(params) {
  parts_->map.go_on_with(map);
}
Mapper::Mapper(const Map& map) : Mapper(map, MapperParams{}) {}
Mapper::~Mapper() = default;
Mapper::Mapper(Mapper&&) noexcept = default;
Mapper& Mapper::operator=(Mapper&&) noexcept = default;

TrackedPose Mapper::add(const Scan& scan, const std::optional<Pose2>& T_wheels_base) {
  const TrackedPose tracked = parts_->tracker.add(scan, T_wheels_base, parts_->steps);
  parts_->map.add(std::move(parts_->steps));
  return tracked;
}

void Mapper::add_turn_rate(Timestamp stamp, double turn_rad_per_s) {
  parts_->tracker.add_turn_rate(stamp, turn_rad_per_s);
}

Map Mapper::finish() const { return parts_->map.make(parts_->tracker.sensors()); }

std::size_t Mapper::num_scans() const { return parts_->map.num_scans(); }

Map merge(std::span<const Map> maps, const MapperParams& params) {
  params.validate();
  if (maps.empty()) throw ParameterError("maps", "must be one at least");
  GrowingMap merged(params);
  for (const Map& map : maps) merged.add(map);
  merged.date_by_stamps();
  return merged.make({});
}

Map merge(std::span<const Map> maps) { return merge(maps, MapperParams{}); }

}  // namespace setsquare
