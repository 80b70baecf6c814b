// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <vector>

#include "setsquare/drawing/text.hpp"
#include "setsquare/report/match/figures/figures.hpp"
#include "setsquare/report/match/figures/plot_panel.hpp"
#include "setsquare/report/palette.hpp"

namespace setsquare {
namespace {

constexpr double kPanelWidth_px = kFigureWidth_px / 3.0;
constexpr double kPanelHeight_px = 185.0;

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

std::int32_t highest(const ProjectedProfile& profile) {
  return *std::max_element(profile.counts.begin(), profile.counts.end());
}

void draw_row(
    SvgCanvas& canvas, int row, const StoryScan& scan, const std::string& name, Color value) {
  struct Shown {
    const ProjectedProfile& profile;
    std::string title;
  };
  const Shown shown[] = {
      {scan.along, joined({name, " along x' (theta_D)"})},
      {scan.across, joined({name, " along y' (theta_D + 90 deg)"})},
      {scan.off,
       joined({name, " off it (theta_D + ", fixed(deg_from_rad(kOffDirection_rad), 0), " deg)"})}};
  const double top =
      1.1 * std::max({1, highest(scan.along), highest(scan.across), highest(scan.off)});
  const double reach_m = scan.along.bins.max_distance_m;
  int column = 0;
  for (const Shown& one : shown) {
    const Eigen::Vector2d corner(kPanelWidth_px * column, kPanelHeight_px * row);
    PlotPanel panel(canvas,
                    corner,
                    {kPanelWidth_px, kPanelHeight_px},
                    {-reach_m, reach_m},
                    {0.0, top},
                    {one.title, "rho [m]", column == 0 ? "points a bin" : ""});
    panel.outline(outline_of(one.profile), value);
    ++column;
  }
}

}  // namespace

SvgCanvas profile_figure(const MatchStory& story) {
  SvgCanvas canvas(kFigureWidth_px, 2.0 * kPanelHeight_px);
  draw_row(canvas, 0, story.reference, "Reference", palette::kReference);
  draw_row(canvas, 1, story.current, "Current", palette::kCurrent);
  return canvas;
}

}  // namespace setsquare
