// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "setsquare/sim/building/sketch.hpp"

namespace setsquare {

/// The floor of one room while it is furnished: it knows what is taken already, where doors need
/// free floor, and where the route runs.
class RoomFloor {
 public:
  /// The sketch must outlive it.
  RoomFloor(BuildingSketch& sketch, ConvexPolygon outline);

  [[nodiscard]] const ConvexPolygon& outline() const { return outline_; }

  /// Whether the footprint lies in the room, on free floor, and `to_route_m` from the route.
  [[nodiscard]] bool is_free(const ConvexPolygon& footprint, double to_route_m = 0.45) const;

  /// Takes the floor if it is free; otherwise nothing happens and the answer is false.
  bool take(const ConvexPolygon& footprint, double to_route_m = 0.45);

 private:
  BuildingSketch& sketch_;
  ConvexPolygon outline_;
  std::vector<ConvexPolygon> taken_;  ///< Footprints, floor before doors: as far as they are near.
  std::vector<ConvexPolygon> route_;  ///< Pieces of the route that are near.
};

}  // namespace setsquare
