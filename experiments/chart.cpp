// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/chart.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/drawing/svg_canvas.hpp"
#include "setsquare/drawing/text.hpp"
#include "setsquare/report/nice_number.hpp"

namespace setsquare::experiments {
namespace {

constexpr double kWidth_px = 510.0;
constexpr double kHeight_px = 310.0;
constexpr double kLeft_px = 58.0;
constexpr double kRight_px = 494.0;
constexpr double kTop_px = 44.0;
constexpr double kBottom_px = 262.0;

double x_px(const Chart& chart, double x) {
  return kLeft_px + (kRight_px - kLeft_px) * (x - chart.x_low) / (chart.x_high - chart.x_low);
}

double y_px(const Chart& chart, double y) {
  return kBottom_px - (kBottom_px - kTop_px) * (y - chart.y_low) / (chart.y_high - chart.y_low);
}

std::string line_svg(double x1, double y1, double x2, double y2) {
  return joined({"<path class=\"guide\" d=\"M",
                 svg_number(x1),
                 " ",
                 svg_number(y1),
                 "L",
                 svg_number(x2),
                 " ",
                 svg_number(y2),
                 "\"/>\n"});
}

std::string text_svg(double x,
                     double y,
                     std::string_view words,
                     std::string_view anchor,
                     std::string_view attributes = "") {
  return joined({"<text x=\"",
                 svg_number(x),
                 "\" y=\"",
                 svg_number(y),
                 "\" text-anchor=\"",
                 anchor,
                 "\" ",
                 attributes,
                 ">",
                 escape_xml(words),
                 "</text>\n"});
}

std::string axes_svg(const Chart& chart) {
  std::string svg;
  const std::vector<double> y_ticks = nice_ticks(chart.y_low, chart.y_high, 6);
  const int y_decimals = decimals_for_step(y_ticks.size() > 1 ? y_ticks[1] - y_ticks[0] : 1.0);
  for (const double y : y_ticks) {
    svg += line_svg(kLeft_px, y_px(chart, y), kRight_px, y_px(chart, y));
    svg += text_svg(
        kLeft_px - 6.0, y_px(chart, y) + 4.0, fixed(y, y_decimals), "end", "class=\"faint\"");
  }
  if (chart.categories.empty()) {
    const std::vector<double> x_ticks = nice_ticks(chart.x_low, chart.x_high, 8);
    const int x_decimals = decimals_for_step(x_ticks.size() > 1 ? x_ticks[1] - x_ticks[0] : 1.0);
    for (const double x : x_ticks) {
      svg += text_svg(
          x_px(chart, x), kBottom_px + 16.0, fixed(x, x_decimals), "middle", "class=\"faint\"");
    }
  }
  for (std::size_t i = 0; i < chart.categories.size(); ++i) {
    svg += text_svg(x_px(chart, static_cast<double>(i)),
                    kBottom_px + 16.0,
                    chart.categories[i],
                    "middle",
                    "class=\"faint\"");
  }
  svg += text_svg(0.5 * (kLeft_px + kRight_px), kBottom_px + 36.0, chart.x_label, "middle");
  svg += text_svg(0.0, 0.0, chart.y_label, "middle", "transform=\"translate(14 153) rotate(-90)\"");
  return svg + text_svg(kLeft_px, 16.0, chart.title, "start", "font-weight=\"bold\"");
}

std::string series_svg(const Chart& chart, const Series& series, const std::string& style) {
  std::string path;
  std::string dots;
  bool is_broken = true;
  for (const Eigen::Vector2d& point : series.points) {
    if (!point.allFinite()) {
      is_broken = true;
      continue;
    }
    const double y = std::clamp(point.y(), chart.y_low, chart.y_high);
    const std::string x_text = svg_number(x_px(chart, point.x()));
    const std::string y_text = svg_number(y_px(chart, y));
    path += joined({is_broken ? "M" : "L", x_text, " ", y_text});
    if (series.points.size() <= 40) {
      dots += joined(
          {"<circle class=\"", style, "\" cx=\"", x_text, "\" cy=\"", y_text, "\" r=\"3\"/>\n"});
    }
    is_broken = false;
  }
  return joined({"<path class=\"curve ", style, "\" d=\"", path, "\"/>\n", dots});
}

}  // namespace

double highest_y(const std::vector<Series>& series, double least) {
  double highest = least;
  for (const Series& one : series) {
    for (const Eigen::Vector2d& point : one.points) {
      if (point.allFinite()) highest = std::max(highest, point.y());
    }
  }
  return highest;
}

std::string chart_svg(const Chart& chart) {
  std::string svg = joined({"<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"",
                            svg_number(kWidth_px),
                            "\" height=\"",
                            svg_number(kHeight_px),
                            "\" viewBox=\"0 0 ",
                            svg_number(kWidth_px),
                            " ",
                            svg_number(kHeight_px),
                            "\" role=\"img\">\n",
                            axes_svg(chart)});
  double legend_px = kLeft_px;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const std::string style = joined({"s", std::to_string(1 + i % 5)});
    svg += series_svg(chart, chart.series[i], style);
    svg += joined({"<circle class=\"",
                   style,
                   "\" cx=\"",
                   svg_number(legend_px + 5.0),
                   "\" cy=\"30\" r=\"4\"/>\n"});
    svg += text_svg(legend_px + 14.0, 34.0, chart.series[i].name, "start");
    legend_px += 28.0 + 6.6 * static_cast<double>(chart.series[i].name.size());
  }
  return svg + "</svg>\n";
}

}  // namespace setsquare::experiments
