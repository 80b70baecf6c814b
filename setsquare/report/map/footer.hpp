// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "setsquare/drawing/image.hpp"
#include "setsquare/drawing/paint.hpp"

namespace setsquare {

/// One line of a legend: a disc or a piece of line in its colour, and what it means.
struct LegendEntry {
  std::string words;
  Color value;
  double disc_radius = 0.0;  ///< In heights of a capital letter; 0 for a piece of line.
};

/// Draws a bar of a round length, at most `max_length_px` long, with its label, from `start` to the
/// right; the bar is centred on start's row.
void draw_scale_bar(Image& image,
                    const PixelPoint& start,
                    double max_length_px,
                    double pixels_per_m,
                    double letter_px);

/// Draws the entries side by side so that the last one ends at `end`, centred on its row.
void draw_legend(Image& image,
                 const PixelPoint& end,
                 std::span<const LegendEntry> entries,
                 double letter_px);

/// Width that draw_legend needs.
[[nodiscard]] double legend_width_px(std::span<const LegendEntry> entries, double letter_px);

}  // namespace setsquare
