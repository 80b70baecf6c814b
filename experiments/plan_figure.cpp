// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/plan_figure.hpp"

#include <algorithm>
#include <Eigen/Geometry>

#include "setsquare/drawing/svg_canvas.hpp"
#include "setsquare/drawing/text.hpp"

namespace setsquare::experiments {
namespace {

constexpr double kWidth_px = 1000.0;
constexpr double kMaxHeight_px = 700.0;
constexpr double kMargin_px = 12.0;
constexpr double kLegend_px = 22.0;

/// From metres of the map to pixels, y up.
struct PlanScale {
  Eigen::AlignedBox2d box_m;
  double px_per_m = 1.0;

  [[nodiscard]] std::string at(const Eigen::Vector2d& p_m) const {
    return joined({svg_number(kMargin_px + px_per_m * (p_m.x() - box_m.min().x())),
                   " ",
                   svg_number(kLegend_px + kMargin_px + px_per_m * (box_m.max().y() - p_m.y()))});
  }
  [[nodiscard]] double height_px() const {
    return kLegend_px + 2.0 * kMargin_px + px_per_m * box_m.sizes().y();
  }
};

PlanScale scale_of(const FloorPlan& plan, const std::vector<NamedPath>& paths) {
  PlanScale scale;
  for (const PlanSegment& segment : plan.segments) {
    scale.box_m.extend(segment.start_m).extend(segment.end_m);
  }
  for (const NamedPath& path : paths) {
    for (const Pose2& pose : path.T_map_base) scale.box_m.extend(pose.translation());
  }
  const Eigen::Vector2d size_m = scale.box_m.sizes().cwiseMax(1.0);
  scale.px_per_m =
      std::min((kWidth_px - 2.0 * kMargin_px) / size_m.x(), kMaxHeight_px / size_m.y());
  return scale;
}

std::string walls_svg(const FloorPlan& plan, const PlanScale& scale) {
  std::string path;
  for (const PlanSegment& segment : plan.segments) {
    path += joined({"M", scale.at(segment.start_m), "L", scale.at(segment.end_m)});
  }
  return joined({"<path class=\"wall\" d=\"", path, "\"/>\n"});
}

std::string dots_svg(const NamedPath& path, const PlanScale& scale, const std::string& style) {
  std::string svg;
  for (std::size_t i = 0; i < path.T_map_base.size(); ++i) {
    svg += joined({"<g transform=\"translate(",
                   scale.at(path.T_map_base[i].translation()),
                   ")\"><circle class=\"",
                   style,
                   "\" r=\"3\"/><text x=\"5\" y=\"-5\">",
                   std::to_string(i),
                   "</text></g>\n"});
  }
  return svg;
}

}  // namespace

std::string plan_svg(const FloorPlan& plan, const std::vector<NamedPath>& paths, bool has_dots) {
  const PlanScale scale = scale_of(plan, paths);
  const std::string height = svg_number(scale.height_px());
  std::string svg = joined({"<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1000\" height=\"",
                            height,
                            "\" viewBox=\"0 0 1000 ",
                            height,
                            "\" role=\"img\">\n",
                            walls_svg(plan, scale)});
  double legend_px = kMargin_px;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const std::string style = joined({"s", std::to_string(1 + i % 5)});
    std::string line;
    for (const Pose2& pose : paths[i].T_map_base) {
      line += joined({line.empty() ? "M" : "L", scale.at(pose.translation())});
    }
    svg += joined({"<path class=\"curve ", style, "\" d=\"", line, "\"/>\n"});
    if (has_dots) svg += dots_svg(paths[i], scale, style);
    svg += joined({"<circle class=\"",
                   style,
                   "\" cx=\"",
                   svg_number(legend_px + 5.0),
                   "\" cy=\"10\" r=\"4\"/><text x=\"",
                   svg_number(legend_px + 14.0),
                   "\" y=\"14\">",
                   escape_xml(paths[i].name),
                   "</text>\n"});
    legend_px += 40.0 + 6.6 * static_cast<double>(paths[i].name.size());
  }
  return svg + "</svg>\n";
}

}  // namespace setsquare::experiments
