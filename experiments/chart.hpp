// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace setsquare::experiments {

/// A curve of a chart. Points with NaN break it.
struct Series {
  std::string name;
  std::vector<Eigen::Vector2d> points;
};

/// A chart with its own colours of the page's style, one of five a series.
struct Chart {
  std::string title;
  std::string x_label;  ///< With its unit: "overlap [%]".
  std::string y_label;
  double x_low = 0.0;
  double x_high = 1.0;
  double y_low = 0.0;
  double y_high = 1.0;
  /// Where not empty, x = 0, 1, ... are these, and they label the axis.
  std::vector<std::string> categories = {};
  std::vector<Series> series;
};

/// The highest y of all series, or `least` where that is higher.
[[nodiscard]] double highest_y(const std::vector<Series>& series, double least);

/// The chart as an svg element.
[[nodiscard]] std::string chart_svg(const Chart& chart);

}  // namespace setsquare::experiments
