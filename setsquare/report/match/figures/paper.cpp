// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/drawing/text.hpp"
#include "setsquare/report/match/figures/figures.hpp"
#include "setsquare/report/palette.hpp"
#include "setsquare/report/plot_panel.hpp"

namespace setsquare {
namespace {

constexpr std::array<Color, 4> kRotationColors = {
    palette::kAnswer, palette::kRunnerUp, color(0x8a6d1f), color(0x7a8794)};

SvgCanvas points_panel(const PointSet& points,
                       const PointSet& all,
                       const std::string& title,
                       Color value) {
  const Eigen::Vector2d size(kFigureWidth_px / 4.0, kFigureWidth_px / 4.0);
  SvgCanvas canvas(size.x(), size.y());
  const EqualRanges ranges = equal_ranges(plotted_points(all), size);
  PlotPanel panel(canvas, {0.0, 0.0}, size, ranges.x, ranges.y, {title, "x [m]", "y [m]"});
  panel.dots(plotted_points(points), value, 1.5);
  panel.sensor({0.0, 0.0}, 0.0, palette::kInk);
  return canvas;
}

/// M over its mean against theta in degrees; 0 where there are no points.
std::vector<Eigen::Vector2d> relative_curve(const PaperScan& scan) {
  const double sum = std::accumulate(scan.moments.begin(), scan.moments.end(), 0.0);
  const double mean = sum / static_cast<double>(scan.moments.size());
  std::vector<Eigen::Vector2d> curve;
  curve.reserve(scan.moments.size());
  for (std::size_t j = 0; j < scan.moments.size(); ++j) {
    curve.emplace_back(deg_from_rad(scan.directions.direction_rad(j)),
                       mean > 0.0 ? scan.moments[j] / mean : 0.0);
  }
  return curve;
}

double highest_of(const std::vector<Eigen::Vector2d>& curve) {
  double value = 1.0;
  for (const Eigen::Vector2d& point : curve) value = std::max(value, point.y());
  return value;
}

void mark_dominant(
    PlotPanel& panel, const PaperScan& scan, const std::string& name, Color value, int line) {
  double theta_deg = deg_from_rad(scan.dominant.theta_rad);
  while (theta_deg < 0.0) theta_deg += 180.0;
  panel.vertical(
      theta_deg, value, fmt::format("theta_D {} {} deg", name, fixed(theta_deg, 1)), line);
}

/// The outline of the bins.
std::vector<Eigen::Vector2d> outline_of(const ProjectedProfile& profile) {
  std::vector<Eigen::Vector2d> outline;
  outline.reserve(2 * profile.counts.size());
  for (std::size_t k = 0; k < profile.counts.size(); ++k) {
    const double low_m =
        static_cast<double>(k) * profile.bins.bin_width_m - profile.bins.max_distance_m;
    outline.emplace_back(low_m, profile.counts[k]);
    outline.emplace_back(low_m + profile.bins.bin_width_m, profile.counts[k]);
  }
  return outline;
}

std::int32_t highest_count(const ProjectedProfile& profile) {
  return *std::max_element(profile.counts.begin(), profile.counts.end());
}

void add_profiles(const PaperScan& scan, const std::string& name, Color value, Figure& figure) {
  const std::pair<const ProjectedProfile&, std::string> shown[] = {
      {scan.along, fmt::format("{} along x' (theta_D)", name)},
      {scan.across, fmt::format("{} along y' (theta_D + 90 deg)", name)},
      {scan.off,
       fmt::format(
           "{} off it (theta_D + {} deg)", name, fixed(deg_from_rad(kOffDirection_rad), 0))}};
  const double top =
      1.1 *
      std::max({1, highest_count(scan.along), highest_count(scan.across), highest_count(scan.off)});
  const double reach_m = scan.along.bins.max_distance_m;
  const Eigen::Vector2d size(kFigureWidth_px / 3.0, 185.0);
  for (const auto& [profile, title] : shown) {
    SvgCanvas canvas(size.x(), size.y());
    PlotPanel panel(canvas,
                    {0.0, 0.0},
                    size,
                    {-reach_m, reach_m},
                    {0.0, top},
                    {title, "rho [m]", "points per bin"});
    panel.outline(outline_of(profile), value);
    figure.push_back(canvas);
  }
}

/// One axis of one rotation.
struct AxisCurve {
  const PaperRotation& rotation;
  const std::vector<std::int32_t>& correlation;
  double shift_m;
};

std::vector<AxisCurve> curves_of_axis(const PaperEvidence& looked_at, bool is_along) {
  std::vector<AxisCurve> curves;
  for (const PaperRotation& rotation : looked_at.rotations) {
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

SvgCanvas axis_panel(const PaperEvidence& looked_at, bool is_along) {
  const std::vector<AxisCurve> curves = curves_of_axis(looked_at, is_along);
  const ShiftSearch& shifts = looked_at.shifts;
  double top = 1.0;
  for (const AxisCurve& curve : curves) {
    for (const std::int32_t value : curve.correlation) top = std::max<double>(top, value);
  }
  const Eigen::Vector2d size(kFigureWidth_px / 2.0, 300.0);
  SvgCanvas canvas(size.x(), size.y());
  PlotPanel panel(canvas,
                  {0.0, 0.0},
                  size,
                  {-shifts.max_shift_m, shifts.max_shift_m},
                  {0.0, 1.45 * top},
                  {is_along ? "Along x'" : "Along y'", "shift lambda [m]", "Corr(lambda)"});
  for (std::size_t i = curves.size(); i-- > 0;) {  // the answer's last, on top
    panel.curve(
        plotted(curves[i], shifts), kRotationColors[i], i == 0 ? 1.8 : 1.0, i == 0 ? 1.0 : 0.8);
  }
  for (std::size_t i = 0; i < curves.size(); ++i) {
    panel.ring(curves[i].shift_m, value_at_choice(curves[i], shifts), kRotationColors[i]);
    panel.remark(curves[i].rotation.label, kRotationColors[i], static_cast<int>(i));
  }
  if (!curves.empty()) {
    panel.vertical(curves[0].shift_m,
                   kRotationColors[0],
                   fmt::format("chosen: {} m", fixed(curves[0].shift_m, 3)));
  }
  return canvas;
}

}  // namespace

Figure thinning_figure(const MatchStory& story, const PaperEvidence& looked_at) {
  Figure figure;
  const auto add_both =
      [&](const StoryScan& all, const PaperScan& few, const char* name, Color value) {
        figure.push_back(points_panel(
            all.points, all.points, fmt::format("{}: {} returns", name, all.points.size()), value));
        figure.push_back(points_panel(
            few.thinned, all.points, fmt::format("thinned: {} points", few.thinned.size()), value));
      };
  add_both(story.reference, looked_at.reference, "Reference", palette::kReference);
  add_both(story.current, looked_at.current, "Current", palette::kCurrent);
  return figure;
}

Figure direction_figure(const PaperEvidence& looked_at) {
  const Eigen::Vector2d size(kFigureWidth_px, 250.0);
  SvgCanvas canvas(size.x(), size.y());
  const auto reference = relative_curve(looked_at.reference);
  const auto current = relative_curve(looked_at.current);
  const double top = 1.08 * std::max(highest_of(reference), highest_of(current));
  PlotPanel panel(canvas,
                  {0.0, 0.0},
                  size,
                  {0.0, 180.0},
                  {0.0, top},
                  {"Second moment of the profile's power spectrum, both scans",
                   "theta [deg]",
                   "M(theta) / mean"});
  panel.curve(reference, palette::kReference, 1.6);
  panel.curve(current, palette::kCurrent, 1.6);
  mark_dominant(panel, looked_at.reference, "reference", palette::kReference, 0);
  mark_dominant(panel, looked_at.current, "current", palette::kCurrent, 1);
  return {canvas};
}

Figure profile_figure(const PaperEvidence& looked_at) {
  Figure figure;
  add_profiles(looked_at.reference, "Reference", palette::kReference, figure);
  add_profiles(looked_at.current, "Current", palette::kCurrent, figure);
  return figure;
}

Figure correlation_figure(const PaperEvidence& looked_at) {
  return {axis_panel(looked_at, true), axis_panel(looked_at, false)};
}

}  // namespace setsquare
