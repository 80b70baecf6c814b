// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "setsquare/drawing/text.hpp"
#include "setsquare/report/match/figures/figures.hpp"
#include "setsquare/report/match/figures/plot_panel.hpp"
#include "setsquare/report/palette.hpp"

namespace setsquare {
namespace {

constexpr double kPanelWidth_px = kFigureWidth_px / 2.0;
constexpr double kCorrelationHeight_px = 300.0;
constexpr std::array<Color, 4> kColors = {
    palette::kAnswer, palette::kRunnerUp, color(0x8a6d1f), color(0x7a8794)};

/// One axis of one rotation.
struct AxisCurve {
  const StoryRotation& rotation;
  const std::vector<std::int32_t>& correlation;
  double shift_m;
};

std::vector<AxisCurve> curves_of_axis(const MatchStory& story, bool is_along) {
  std::vector<AxisCurve> curves;
  for (const StoryRotation& rotation : story.rotations) {
    curves.push_back({rotation,
                      is_along ? rotation.along : rotation.across,
                      is_along ? rotation.shift_along_m : rotation.shift_across_m});
  }
  return curves;
}

std::vector<Eigen::Vector2d> plotted(const AxisCurve& curve, const ShiftSearch& shifts) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(curve.correlation.size());
  for (std::size_t i = 0; i < curve.correlation.size(); ++i) {
    points.emplace_back(shifts.shift_m(i), curve.correlation[i]);
  }
  return points;
}

/// The correlation at the chosen shift, 0 where that lies outside the search.
double value_at_choice(const AxisCurve& curve, const ShiftSearch& shifts) {
  const double index =
      std::round(curve.shift_m / shifts.step_m) + static_cast<double>(shifts.max_lag());
  const bool is_inside = index >= 0.0 && index < static_cast<double>(curve.correlation.size());
  return is_inside ? curve.correlation[static_cast<std::size_t>(index)] : 0.0;
}

void draw_axis(SvgCanvas& canvas, int column, const MatchStory& story) {
  const bool is_along = column == 0;
  const std::vector<AxisCurve> curves = curves_of_axis(story, is_along);
  double top = 1.0;
  for (const AxisCurve& curve : curves) {
    for (const std::int32_t value : curve.correlation) top = std::max<double>(top, value);
  }
  PlotPanel panel(
      canvas,
      {kPanelWidth_px * column, 0.0},
      {kPanelWidth_px, kCorrelationHeight_px},
      {-story.shifts.max_shift_m, story.shifts.max_shift_m},
      {0.0, 1.45 * top},
      {is_along ? "Along x'" : "Along y'", "shift lambda [m]", is_along ? "Corr(lambda)" : ""});
  for (std::size_t i = curves.size(); i-- > 0;) {  // the answer's last, on top
    panel.curve(
        plotted(curves[i], story.shifts), kColors[i], i == 0 ? 1.8 : 1.0, i == 0 ? 1.0 : 0.8);
  }
  for (std::size_t i = 0; i < curves.size(); ++i) {
    panel.ring(curves[i].shift_m, value_at_choice(curves[i], story.shifts), kColors[i]);
    panel.remark(curves[i].rotation.label, kColors[i], static_cast<int>(i));
  }
  if (!curves.empty()) {
    panel.vertical(
        curves[0].shift_m, kColors[0], joined({"chosen: ", fixed(curves[0].shift_m, 3), " m"}));
  }
}

}  // namespace

SvgCanvas correlation_figure(const MatchStory& story) {
  SvgCanvas canvas(kFigureWidth_px, kCorrelationHeight_px);
  draw_axis(canvas, 0, story);
  draw_axis(canvas, 1, story);
  return canvas;
}

}  // namespace setsquare
