// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/footer.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "setsquare/drawing/stroke_font.hpp"
#include "setsquare/drawing/text.hpp"
#include "setsquare/report/nice_number.hpp"
#include "setsquare/report/palette.hpp"

namespace setsquare {
namespace {

// In heights of a capital letter.
constexpr double kSymbolWidth = 2.2;
constexpr double kGapToWords = 0.9;
constexpr double kGapBetweenEntries = 2.2;

double width_of(const LegendEntry& entry) {
  return kSymbolWidth + kGapToWords + text_width(entry.words);
}

}  // namespace

void draw_scale_bar(Image& image,
                    const PixelPoint& start,
                    double max_length_px,
                    double pixels_per_m,
                    double letter_px) {
  const double length_m = nice_number_below(max_length_px / pixels_per_m);
  const double length_px = length_m * pixels_per_m;
  const double half_height_px = 0.28 * letter_px;
  const PixelPoint low = start - PixelPoint(0.0, half_height_px);
  const PixelPoint high = start + PixelPoint(length_px, half_height_px);
  const PixelPoint rim(1.5, 1.5);
  fill_rectangle(image, low - rim, high + rim, palette::kInk);
  constexpr int kNumParts = 4;
  for (int part = 1; part < kNumParts; part += 2) {
    const PixelPoint from(start.x() + length_px * part / kNumParts, low.y());
    const PixelPoint to(start.x() + length_px * (part + 1) / kNumParts, high.y());
    fill_rectangle(image, from, to, palette::kPaper);
  }
  const std::string label = fixed(length_m, decimals_for_step(length_m)) + " m";
  const PixelPoint words = start + PixelPoint(length_px + letter_px, 0.5 * letter_px);
  draw_text(image, words, label, letter_px, palette::kInk);
}

void draw_legend(Image& image,
                 const PixelPoint& end,
                 std::span<const LegendEntry> entries,
                 double letter_px) {
  double x = end.x() - legend_width_px(entries, letter_px);
  for (const LegendEntry& entry : entries) {
    const double symbol_px = kSymbolWidth * letter_px;
    if (entry.disc_radius > 0.0) {
      fill_disc(image, {x + 0.5 * symbol_px, end.y()}, entry.disc_radius * letter_px, entry.value);
    } else {
      const std::array<PixelPoint, 2> line = {PixelPoint(x, end.y()),
                                              PixelPoint(x + symbol_px, end.y())};
      draw_polyline(image, line, 0.3 * letter_px, entry.value);
    }
    const PixelPoint words(x + symbol_px + kGapToWords * letter_px, end.y() + 0.5 * letter_px);
    draw_text(image, words, entry.words, letter_px, palette::kInk);
    x += (width_of(entry) + kGapBetweenEntries) * letter_px;
  }
}

double legend_width_px(std::span<const LegendEntry> entries, double letter_px) {
  if (entries.empty()) return 0.0;
  double width = kGapBetweenEntries * static_cast<double>(entries.size() - 1);
  for (const LegendEntry& entry : entries) width += width_of(entry);
  return width * letter_px;
}

}  // namespace setsquare
