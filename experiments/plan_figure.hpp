// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/sim/floor_plan.hpp"

namespace setsquare::experiments {

/// A way through a plan.
struct NamedPath {
  std::string name;
  std::vector<Pose2> T_map_base;
};

/// A floor plan and ways through it, to scale, as an svg element in the page's colours; `has_dots`:
/// each pose is a dot with its number.
[[nodiscard]] std::string plan_svg(const FloorPlan& plan,
                                   const std::vector<NamedPath>& paths,
                                   bool has_dots = false);

}  // namespace setsquare::experiments
