// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/error_plots.hpp"

#include <algorithm>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/drawing/svg_canvas.hpp"
#include "setsquare/report/palette.hpp"
#include "setsquare/report/plot_panel.hpp"

namespace setsquare {
namespace {

const Eigen::Vector2d kErrorPanel_px(860.0, 260.0);
const Eigen::Vector2d kTrajectoryPanel_px(860.0, 700.0);
constexpr double kPlotMargin_px = 10.0;

SvgCanvas canvas_for(const Eigen::Vector2d& panel_px, int num_panels) {
  const double width_px = panel_px.x() + 2.0 * kPlotMargin_px;
  const double height_px = num_panels * panel_px.y() + 2.0 * kPlotMargin_px;
  SvgCanvas canvas(width_px, height_px);
  canvas.rectangle({0.0, 0.0}, {width_px, height_px}, {.fill = palette::kPaper});
  return canvas;
}

/// From 0 to a little above the largest value.
PlotRange range_up_to(double largest) { return {0.0, largest > 0.0 ? 1.05 * largest : 1.0}; }

struct ErrorPanel {
  PanelLabels labels;
  Color value;
  double unit = 1.0;
};

void draw_errors(SvgCanvas& canvas,
                 int row,
                 const ErrorPanel& panel,
                 std::span<const Timestamp> stamps,
                 std::span<const double> values) {
  std::vector<Eigen::Vector2d> points;
  double largest = 0.0;
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    points.emplace_back(seconds_between(stamps.front(), stamps[i]), panel.unit * values[i]);
    largest = std::max(largest, points.back().y());
  }
  const double last_s = points.empty() ? 0.0 : points.back().x();
  PlotPanel plot(canvas,
                 {kPlotMargin_px, kPlotMargin_px + row * kErrorPanel_px.y()},
                 kErrorPanel_px,
                 {0.0, last_s > 0.0 ? last_s : 1.0},
                 range_up_to(largest),
                 panel.labels);
  plot.dots(points, panel.value, 1.3, 0.8);
}

std::vector<Eigen::Vector2d> positions_of(const Trajectory& trajectory) {
  std::vector<Eigen::Vector2d> positions;
  for (const StampedPose& stamped : trajectory) positions.push_back(stamped.pose.translation());
  return positions;
}

}  // namespace

std::string error_plot_svg(const PlottedErrors& errors) {
  SvgCanvas canvas = canvas_for(kErrorPanel_px, 2);
  draw_errors(canvas,
              0,
              {{"Position error", "time [s]", "error [m]"}, palette::kCurrent},
              errors.stamps,
              errors.translation_m);
  draw_errors(
      canvas,
      1,
      {{"Heading error", "time [s]", "error [deg]"}, palette::kReference, deg_from_rad(1.0)},
      errors.stamps,
      errors.rotation_rad);
  return canvas.document();
}

std::string trajectory_plot_svg(const Trajectory& aligned, const Trajectory& reference) {
  const std::vector<Eigen::Vector2d> judged_m = positions_of(aligned);
  const std::vector<Eigen::Vector2d> reference_m = positions_of(reference);
  std::vector<Eigen::Vector2d> all_m = judged_m;
  all_m.insert(all_m.end(), reference_m.begin(), reference_m.end());
  const EqualRanges ranges = equal_ranges(all_m, kTrajectoryPanel_px);
  SvgCanvas canvas = canvas_for(kTrajectoryPanel_px, 1);
  PlotPanel plot(canvas,
                 {kPlotMargin_px, kPlotMargin_px},
                 kTrajectoryPanel_px,
                 ranges.x,
                 ranges.y,
                 {"Trajectory, aligned", "x [m]", "y [m]"});
  plot.curve(reference_m, palette::kReference, 3.0, 0.6);
  plot.curve(judged_m, palette::kCurrent, 1.2);
  plot.ring(reference_m.front().x(), reference_m.front().y(), palette::kStart);
  plot.remark("reference", palette::kReference, 0);
  plot.remark("trajectory", palette::kCurrent, 1);
  plot.remark("start", palette::kStart, 2);
  return canvas.document();
}

}  // namespace setsquare
