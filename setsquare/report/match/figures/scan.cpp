// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include "setsquare/drawing/text.hpp"
#include "setsquare/report/match/figures/figures.hpp"
#include "setsquare/report/match/figures/plot_panel.hpp"
#include "setsquare/report/match/figures/plotted_points.hpp"
#include "setsquare/report/palette.hpp"

namespace setsquare {
namespace {

constexpr double kPanel_px = kFigureWidth_px / 4.0;

void draw_scan(SvgCanvas& canvas,
               int column,
               const PointSet& points,
               const EqualRanges& ranges,
               const std::string& title,
               Color value) {
  const Eigen::Vector2d corner(kPanel_px * column, 0.0);
  const PanelLabels labels = {title, "x [m]", column == 0 ? "y [m]" : ""};
  PlotPanel panel(canvas, corner, {kPanel_px, kPanel_px}, ranges.x, ranges.y, labels);
  panel.dots(plotted_points(points), value, 1.5);
  panel.sensor({0.0, 0.0}, 0.0, palette::kInk);
}

}  // namespace

SvgCanvas scan_figure(const MatchStory& story) {
  SvgCanvas canvas(kFigureWidth_px, kPanel_px);
  int column = 0;
  const auto draw_both = [&](const StoryScan& scan, const std::string& name, Color value) {
    const EqualRanges ranges = equal_ranges(plotted_points(scan.points), {kPanel_px, kPanel_px});
    const std::string all = joined({name, ": ", std::to_string(scan.points.size()), " returns"});
    const std::string few = joined({"thinned: ", std::to_string(scan.thinned.size()), " points"});
    draw_scan(canvas, column++, scan.points, ranges, all, value);
    draw_scan(canvas, column++, scan.thinned, ranges, few, value);
  };
  draw_both(story.reference, "Reference", palette::kReference);
  draw_both(story.current, "Current", palette::kCurrent);
  return canvas;
}

}  // namespace setsquare
