// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/doubt_marks.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "setsquare/drawing/paint.hpp"
#include "setsquare/report/palette.hpp"

namespace setsquare {
namespace {

/// In heights of a capital letter.
constexpr double kDoubtRadius = 1.1;

/// The first place at or right of `wanted` that no other mark covers.
PixelPoint free_place(PixelPoint wanted, const std::vector<PixelPoint>& taken, double radius_px) {
  const auto covers = [&](const PixelPoint& other) {
    return (other - wanted).norm() < 2.0 * radius_px;
  };
  while (std::any_of(taken.begin(), taken.end(), covers)) wanted.x() += 2.2 * radius_px;
  return wanted;
}

}  // namespace

void draw_doubts(Image& image,
                 const MapLayout& layout,
                 const OccupancyGrid& grid,
                 std::span<const MapDoubt> doubts) {
  std::vector<StampedPose> places;
  for (const MapDoubt& doubt : doubts) {
    places.push_back({doubt.first_stamp, {doubt.place_m.x(), doubt.place_m.y(), 0.0}});
  }
  const std::vector<Eigen::Vector2d> cells = path_in_cells(grid, places);
  const double letter_px = layout.letter_px;
  const double radius_px = kDoubtRadius * letter_px;
  std::vector<PixelPoint> taken;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const PixelPoint at = free_place(layout.pixel_of(cells[i]), taken, radius_px);
    taken.push_back(at);
    fill_disc(image, at, radius_px + 0.25 * letter_px, palette::kPaper);
    fill_disc(image, at, radius_px, palette::kDoubt);
    draw_text(image,
              at + PixelPoint(0.0, 0.5 * letter_px),
              std::to_string(i + 1),
              letter_px,
              palette::kPaper,
              TextAnchor::kMiddle);
  }
}

LegendEntry doubt_legend_entry() { return {"doubt", palette::kDoubt, 0.75}; }

}  // namespace setsquare
