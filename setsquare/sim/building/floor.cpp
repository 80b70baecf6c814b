// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/building/floor.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace setsquare {

RoomFloor::RoomFloor(BuildingSketch& sketch, ConvexPolygon outline)
    : sketch_(sketch), outline_(std::move(outline)) {
  constexpr double kNear_m = 0.7;
  const auto is_near = [this](const ConvexPolygon& other) {
    return !are_apart(outline_, other, kNear_m);
  };
  std::copy_if(
      sketch.footprints.begin(), sketch.footprints.end(), std::back_inserter(taken_), is_near);
  std::copy_if(
      sketch.kept_free.begin(), sketch.kept_free.end(), std::back_inserter(taken_), is_near);
  for (std::size_t i = 1; i < sketch.route_m.size(); ++i) {
    const ConvexPolygon piece{sketch.route_m[i - 1], sketch.route_m[i]};
    if (is_near(piece)) route_.push_back(piece);
  }
}

bool RoomFloor::is_free(const ConvexPolygon& footprint, double to_route_m) const {
  constexpr double kBetweenThings_m = 0.005;
  return contains(outline_, footprint) &&
         std::all_of(taken_.begin(),
                     taken_.end(),
                     [&](const ConvexPolygon& other) {
                       return are_apart(footprint, other, kBetweenThings_m);
                     }) &&
         std::all_of(route_.begin(), route_.end(), [&](const ConvexPolygon& piece) {
           return are_apart(footprint, piece, to_route_m);
         });
}

bool RoomFloor::take(const ConvexPolygon& footprint, double to_route_m) {
  if (!is_free(footprint, to_route_m)) return false;
  taken_.push_back(footprint);
  sketch_.footprints.push_back(footprint);
  return true;
}

}  // namespace setsquare
