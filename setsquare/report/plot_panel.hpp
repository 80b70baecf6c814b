// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/drawing/svg_canvas.hpp"
#include "setsquare/scan/point_set.hpp"

namespace setsquare {

/// The part of the plane that a panel shows; low is below high.
struct PlotRange {
  double low = 0.0;
  double high = 1.0;
};

struct PanelLabels {
  std::string title;
  std::string x;  ///< With its unit: "shift [m]".
  std::string y;
};

/// A framed diagram in a picture: guide lines at round numbers, tick labels, and what is plotted,
/// cut off at the frame. Positions are in the diagram's own units, y up.
class PlotPanel {
 public:
  /// Draws the frame with its guides and labels into the rectangle, which includes the labels.
  PlotPanel(SvgCanvas& canvas,
            const Eigen::Vector2d& corner,
            const Eigen::Vector2d& size,
            PlotRange x,
            PlotRange y,
            const PanelLabels& labels);

  [[nodiscard]] Eigen::Vector2d at(double x, double y) const;

  void curve(std::span<const Eigen::Vector2d> points,
             Color value,
             double width_px,
             double opacity = 1.0);
  /// Bars of a profile as one outline with a filled area below.
  void outline(std::span<const Eigen::Vector2d> points, Color value);
  void dots(std::span<const Eigen::Vector2d> points,
            Color value,
            double radius_px,
            double opacity = 1.0);
  /// A vertical line over the whole height, with words next to its top, `line` lines down.
  void vertical(double x, Color value, std::string_view words, int line = 0);
  void ring(double x, double y, Color value);
  /// The sensor's place and the direction that it looks.
  void sensor(const Eigen::Vector2d& place, double heading_rad, Color value);
  /// Words in the upper right corner, `line` lines down.
  void remark(std::string_view words, Color value, int line);

 private:
  [[nodiscard]] std::vector<Eigen::Vector2d> at(std::span<const Eigen::Vector2d> points) const;
  void draw_guides(const PanelLabels& labels, PlotRange x, PlotRange y);

  SvgCanvas& canvas_;
  Eigen::Vector2d corner_;  ///< Of the diagram itself.
  Eigen::Vector2d size_;
  PlotRange x_;
  PlotRange y_;
};

/// The ranges that show the points at equal scale in a panel of this size, with a margin; a square
/// of two metres where there are none.
struct EqualRanges {
  PlotRange x;
  PlotRange y;
};
[[nodiscard]] EqualRanges equal_ranges(std::span<const Eigen::Vector2d> points,
                                       const Eigen::Vector2d& panel_size);

/// The points in another frame, for a diagram.
[[nodiscard]] std::vector<Eigen::Vector2d> plotted_points(const PointSet& points,
                                                          const Pose2& T_plot_points = {});

}  // namespace setsquare
