// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "apps/setsquare/simulate/options.hpp"
#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/sensing/ray_casting.hpp"

namespace setsquare::app {

/// "x,y x,y ..." in m. Throws Error where it is no such list of two points or more, within 10 km.
[[nodiscard]] std::vector<Eigen::Vector2d> route_from_text(std::string_view text);

/// The building that the options name, or the plan with its route; without people where none are
/// wanted. Throws FileError, FormatError,
/// Error where a plan has no route.
[[nodiscard]] Building world_from(const SimulateOptions& options);

/// Throws Error with the place where a route leads through a wall.
void require_free_route(const RayCaster& caster, const std::vector<Eigen::Vector2d>& route_m);

}  // namespace setsquare::app
