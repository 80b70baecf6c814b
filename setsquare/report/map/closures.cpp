// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/closures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "setsquare/drawing/paint.hpp"
#include "setsquare/report/palette.hpp"

namespace setsquare {
namespace {

/// Finds poses by their stamps.
class StampIndex {
 public:
  explicit StampIndex(std::span<const StampedPose> poses) {
    order_.reserve(poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i) order_.emplace_back(poses[i].stamp, i);
    std::ranges::sort(order_);
  }

  [[nodiscard]] std::optional<std::size_t> find(Timestamp stamp) const {
    const auto found = std::ranges::lower_bound(order_, std::pair(stamp, std::size_t{0}));
    if (found == order_.end() || found->first != stamp) return std::nullopt;
    return found->second;
  }

 private:
  std::vector<std::pair<Timestamp, std::size_t>> order_;
};

struct ClosureStyle {
  bool binds_both_axes;
  Color value;
  const char* words;
};

constexpr std::array<ClosureStyle, 2> kStyles = {
    {{true, palette::kClosure, "loop closure"},
     {false, palette::kAxisClosure, "closure of one axis"}}};

constexpr int kNumWeightShades = 4;

/// From 0, the palest.
int shade_of(const PlacedClosure& closure) {
  return std::clamp(static_cast<int>(closure.weight * kNumWeightShades), 0, kNumWeightShades - 1);
}

/// On the free space that nearly all of them cross, a mixed colour looks as a transparent one.
Color shaded(Color value, int shade) {
  constexpr double kPalest = 0.25;
  return mix(palette::kFree, value, kPalest + (1.0 - kPalest) * shade / (kNumWeightShades - 1));
}

/// A line in short pieces: a long slanting one would have a large box of pixels to look at.
void append_line(std::vector<PixelPoint>& points, const PixelPoint& from, const PixelPoint& to) {
  constexpr double kPiece_px = 16.0;
  const double num_pieces = std::max(1.0, std::ceil((to - from).norm() / kPiece_px));
  for (double piece = 0.0; piece <= num_pieces; ++piece) {
    points.emplace_back(from + (to - from) * (piece / num_pieces));
  }
  points.emplace_back(PixelPoint::Constant(std::nan("")));
}

}  // namespace

PlacedClosures placed_closures(std::span<const LoopClosure> closures,
                               std::span<const StampedPose> T_map_base,
                               std::span<const Eigen::Vector2d> path_cells) {
  PlacedClosures placed;
  if (closures.empty()) return placed;
  const StampIndex index(T_map_base);
  for (const LoopClosure& closure : closures) {
    const auto i = index.find(closure.stamp_i);
    const auto j = index.find(closure.stamp_j);
    if (!closure.is_accepted || !i || !j) continue;
    if (!path_cells[*i].allFinite() || !path_cells[*j].allFinite()) continue;  // Not placed.
    placed.push_back({.from_cells = path_cells[*i],
                      .to_cells = path_cells[*j],
                      .weight = closure.weight,
                      .binds_both_axes = closure.axes == ClosureAxes::kXY});
  }
  return placed;
}

void draw_closures(Image& image, const MapLayout& layout, const PlacedClosures& closures) {
  for (int shade = 0; shade < kNumWeightShades; ++shade) {
    for (const ClosureStyle& style : kStyles) {
      std::vector<PixelPoint> lines;
      std::vector<PixelPoint> dots;
      for (const PlacedClosure& closure : closures) {
        if (closure.binds_both_axes != style.binds_both_axes) continue;
        if (shade_of(closure) != shade) continue;
        const PixelPoint from = layout.pixel_of(closure.from_cells);
        const PixelPoint to = layout.pixel_of(closure.to_cells);
        append_line(lines, from, to);
        append_line(dots, from, from);
        append_line(dots, to, to);
      }
      if (lines.empty()) continue;
      const Color value = shaded(style.value, shade);
      draw_polyline(image, lines, std::max(1.0, 0.08 * layout.letter_px), value);
      draw_polyline(image, dots, std::max(2.5, 0.26 * layout.letter_px), value);
    }
  }
}

std::vector<LegendEntry> legend_entries(const PlacedClosures& closures) {
  std::vector<LegendEntry> entries;
  for (const ClosureStyle& style : kStyles) {
    const bool is_present = std::ranges::any_of(closures, [&style](const PlacedClosure& closure) {
      return closure.binds_both_axes == style.binds_both_axes;
    });
    if (is_present) entries.push_back({.words = style.words, .value = style.value});
  }
  return entries;
}

}  // namespace setsquare
