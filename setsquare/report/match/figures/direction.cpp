// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/drawing/text.hpp"
#include "setsquare/report/match/figures/figures.hpp"
#include "setsquare/report/match/figures/plot_panel.hpp"
#include "setsquare/report/palette.hpp"

namespace setsquare {
namespace {

constexpr double kDirectionHeight_px = 250.0;

/// M over its mean against theta in degrees; 0 where there are no points.
std::vector<Eigen::Vector2d> relative_curve(const StoryScan& scan) {
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

double highest(const std::vector<Eigen::Vector2d>& curve) {
  double value = 1.0;
  for (const Eigen::Vector2d& point : curve) value = std::max(value, point.y());
  return value;
}

void mark_dominant(
    PlotPanel& panel, const StoryScan& scan, const std::string& name, Color value, int line) {
  double theta_deg = deg_from_rad(scan.dominant.theta_rad);
  while (theta_deg < 0.0) theta_deg += 180.0;
  panel.vertical(
      theta_deg, value, joined({"theta_D ", name, " ", fixed(theta_deg, 1), " deg"}), line);
}

}  // namespace

SvgCanvas direction_figure(const MatchStory& story) {
  SvgCanvas canvas(kFigureWidth_px, kDirectionHeight_px);
  const auto reference = relative_curve(story.reference);
  const auto current = relative_curve(story.current);
  const double top = 1.08 * std::max(highest(reference), highest(current));
  PlotPanel panel(canvas,
                  {0.0, 0.0},
                  {kFigureWidth_px, kDirectionHeight_px},
                  {0.0, 180.0},
                  {0.0, top},
                  {"Second moment of the profile's power spectrum, both scans",
                   "theta [deg]",
                   "M(theta) / mean"});
  panel.curve(reference, palette::kReference, 1.6);
  panel.curve(current, palette::kCurrent, 1.6);
  mark_dominant(panel, story.reference, "reference", palette::kReference, 0);
  mark_dominant(panel, story.current, "current", palette::kCurrent, 1);
  return canvas;
}

}  // namespace setsquare
