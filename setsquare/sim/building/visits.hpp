// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "setsquare/sim/building/rooms.hpp"
#include "setsquare/sim/random.hpp"

namespace setsquare {

/// A visit to a room from a corridor or hall: in by its first door, about the room, and out by the
/// last one. The corners of the way, from the place before the first door to that before the last.
struct RoomVisit {
  std::vector<Eigen::Vector2d> corners_m;
};

/// `approach_m`: how far from the wall the way along the corridor runs. None where the room is too
/// small to drive about in.
[[nodiscard]] std::optional<RoomVisit> plan_visit(const Room& room,
                                                  double approach_m,
                                                  Random& random);

}  // namespace setsquare
