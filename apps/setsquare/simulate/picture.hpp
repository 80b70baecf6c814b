// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "setsquare/core/trajectory.hpp"
#include "setsquare/sim/building/building.hpp"

namespace setsquare::app {

/// The floor plan as an SVG document for people: materials by colour, people, where the robot was
/// truly, and a scale bar. y is up.
[[nodiscard]] std::string plan_picture(const Building& world,
                                       const Trajectory& truth,
                                       const std::string& caption);

}  // namespace setsquare::app
