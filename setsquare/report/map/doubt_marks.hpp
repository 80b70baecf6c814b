// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from picture, its only caller, which draws the map itself.
#pragma once

#include <span>

#include "setsquare/drawing/image.hpp"
#include "setsquare/grid/occupancy_grid.hpp"
#include "setsquare/map/doubt.hpp"
#include "setsquare/report/map/footer.hpp"
#include "setsquare/report/map/layout.hpp"

namespace setsquare {

/// Marks each doubt at its place by a disc with its number, counted from 1. Marks that would cover
/// each other move aside.
void draw_doubts(Image& image,
                 const MapLayout& layout,
                 const OccupancyGrid& grid,
                 std::span<const MapDoubt> doubts);

/// What the legend says of them.
[[nodiscard]] LegendEntry doubt_legend_entry();

}  // namespace setsquare
