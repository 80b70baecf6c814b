// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/plot_panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/drawing/text.hpp"
#include "setsquare/report/nice_number.hpp"
#include "setsquare/report/palette.hpp"

namespace setsquare {
namespace {

// Room around a diagram for its labels, in pixels.
constexpr double kLeft_px = 52.0;
constexpr double kRight_px = 10.0;
constexpr double kTop_px = 24.0;
constexpr double kBottom_px = 36.0;
constexpr double kLine_px = 15.0;
constexpr double kTick_px = 11.0;
constexpr double kLabel_px = 12.0;

Eigen::Vector2d inner_margin() { return {kLeft_px + kRight_px, kTop_px + kBottom_px}; }

std::string tick_label(double value, double step) {
  if (std::abs(value) >= 10'000.0 && step >= 1000.0) {
    return fixed(value / 1000.0, decimals_for_step(step / 1000.0)) + "k";
  }
  return fixed(value, decimals_for_step(step));
}

double step_of(const std::vector<double>& ticks) {
  return ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
}

}  // namespace

PlotPanel::PlotPanel(SvgCanvas& canvas,
                     const Eigen::Vector2d& corner,
                     const Eigen::Vector2d& size,
                     PlotRange x,
                     PlotRange y,
                     const PanelLabels& labels)
    : canvas_(canvas),
      corner_(corner + Eigen::Vector2d(kLeft_px, kTop_px)),
      size_(size - inner_margin()),
      x_(x),
      y_(y) {
  canvas_.rectangle(corner_, size_, {.fill = palette::kPaper});
  draw_guides(labels, x, y);
  canvas_.rectangle(corner_, size_, {.stroke = palette::kFrame});
}

Eigen::Vector2d PlotPanel::at(double x, double y) const {
  return {corner_.x() + size_.x() * (x - x_.low) / (x_.high - x_.low),
          corner_.y() + size_.y() * (y_.high - y) / (y_.high - y_.low)};
}

void PlotPanel::draw_guides(const PanelLabels& labels, PlotRange x, PlotRange y) {
  const ShapeStyle guide = {.stroke = palette::kGuide};
  const Eigen::Vector2d end = corner_ + size_;
  const auto x_ticks = nice_ticks(x.low, x.high, std::max(2, static_cast<int>(size_.x() / 55.0)));
  for (const double tick : x_ticks) {
    const double place = at(tick, y.low).x();
    canvas_.line({place, corner_.y()}, {place, end.y()}, guide);
    canvas_.text({place, end.y() + 14.0},
                 tick_label(tick, step_of(x_ticks)),
                 {.size_px = kTick_px, .fill = palette::kFaintInk, .anchor = TextAnchor::kMiddle});
  }
  const auto y_ticks = nice_ticks(y.low, y.high, std::max(2, static_cast<int>(size_.y() / 32.0)));
  for (const double tick : y_ticks) {
    const double place = at(x.low, tick).y();
    canvas_.line({corner_.x(), place}, {end.x(), place}, guide);
    canvas_.text({corner_.x() - 5.0, place + 4.0},
                 tick_label(tick, step_of(y_ticks)),
                 {.size_px = kTick_px, .fill = palette::kFaintInk, .anchor = TextAnchor::kEnd});
  }
  canvas_.text({corner_.x(), corner_.y() - 8.0},
               labels.title,
               {.size_px = 13.0, .fill = palette::kInk, .is_bold = true});
  canvas_.text({corner_.x() + 0.5 * size_.x(), end.y() + 30.0},
               labels.x,
               {.size_px = kLabel_px, .fill = palette::kFaintInk, .anchor = TextAnchor::kMiddle});
  canvas_.text({corner_.x() - 40.0, corner_.y() + 0.5 * size_.y()},
               labels.y,
               {.size_px = kLabel_px,
                .fill = palette::kFaintInk,
                .anchor = TextAnchor::kMiddle,
                .rotation_deg = -90.0});
}

std::vector<Eigen::Vector2d> PlotPanel::at(std::span<const Eigen::Vector2d> points) const {
  std::vector<Eigen::Vector2d> places;
  places.reserve(points.size());
  for (const Eigen::Vector2d& point : points) places.push_back(at(point.x(), point.y()));
  return places;
}

void PlotPanel::curve(std::span<const Eigen::Vector2d> points,
                      Color value,
                      double width_px,
                      double opacity) {
  canvas_.begin_clip(corner_, size_);
  canvas_.polyline(at(points), {.stroke = value, .stroke_width_px = width_px, .opacity = opacity});
  canvas_.end_clip();
}

void PlotPanel::outline(std::span<const Eigen::Vector2d> points, Color value) {
  if (points.empty()) return;
  std::vector<Eigen::Vector2d> area = {at(points.front().x(), 0.0)};
  for (const Eigen::Vector2d& point : points) area.push_back(at(point.x(), point.y()));
  area.push_back(at(points.back().x(), 0.0));
  canvas_.begin_clip(corner_, size_);
  canvas_.polyline(area, {.fill = mix(value, palette::kPaper, 0.55), .stroke = value});
  canvas_.end_clip();
}

void PlotPanel::dots(std::span<const Eigen::Vector2d> points,
                     Color value,
                     double radius_px,
                     double opacity) {
  canvas_.begin_clip(corner_, size_);
  canvas_.dots(at(points), radius_px, value, opacity);
  canvas_.end_clip();
}

void PlotPanel::vertical(double x, Color value, std::string_view words, int line) {
  if (!(x >= x_.low && x <= x_.high)) return;
  const double place = at(x, y_.low).x();
  canvas_.line({place, corner_.y()},
               {place, corner_.y() + size_.y()},
               {.stroke = value, .stroke_width_px = 1.4, .dashes = "5 3"});
  const bool is_right = place > corner_.x() + 0.7 * size_.x();
  canvas_.text({place + (is_right ? -5.0 : 5.0), corner_.y() + 14.0 + kLine_px * line},
               words,
               {.size_px = kLabel_px,
                .fill = value,
                .anchor = is_right ? TextAnchor::kEnd : TextAnchor::kStart});
}

void PlotPanel::ring(double x, double y, Color value) {
  if (!(x >= x_.low && x <= x_.high && y >= y_.low && y <= y_.high)) return;
  canvas_.circle(at(x, y), 5.0, {.stroke = value, .stroke_width_px = 2.0});
}

void PlotPanel::sensor(const Eigen::Vector2d& place, double heading_rad, Color value) {
  const Eigen::Vector2d middle = at(place.x(), place.y());
  const auto corner = [&](double angle_rad, double length_px) {
    return Eigen::Vector2d(middle +
                           length_px * Eigen::Vector2d(std::cos(heading_rad + angle_rad),
                                                       -std::sin(heading_rad + angle_rad)));
  };
  const std::array<Eigen::Vector2d, 5> arrow = {
      corner(0.0, 11.0), corner(2.4, 8.0), corner(kPi, 3.0), corner(-2.4, 8.0), corner(0.0, 11.0)};
  canvas_.begin_clip(corner_, size_);
  canvas_.polyline(arrow, {.fill = value, .stroke = palette::kPaper, .stroke_width_px = 1.2});
  canvas_.end_clip();
}

void PlotPanel::remark(std::string_view words, Color value, int line) {
  canvas_.text({corner_.x() + size_.x() - 6.0, corner_.y() + 16.0 + kLine_px * line},
               words,
               {.size_px = kLabel_px, .fill = value, .anchor = TextAnchor::kEnd});
}

EqualRanges equal_ranges(std::span<const Eigen::Vector2d> points,
                         const Eigen::Vector2d& panel_size) {
  Eigen::Array2d low(0.0, 0.0);
  Eigen::Array2d high(0.0, 0.0);
  for (const Eigen::Vector2d& point : points) {
    low = low.min(point.array());
    high = high.max(point.array());
  }
  constexpr double kMargin = 1.06;
  const Eigen::Array2d middle = 0.5 * (low + high);
  const Eigen::Array2d pixels = (panel_size - inner_margin()).array();
  const double unit_per_pixel =
      std::max(1.0 / pixels.minCoeff(), kMargin * ((high - low) / pixels).maxCoeff());
  const Eigen::Array2d half = 0.5 * unit_per_pixel * pixels;
  return {{middle.x() - half.x(), middle.x() + half.x()},
          {middle.y() - half.y(), middle.y() + half.y()}};
}

std::vector<Eigen::Vector2d> plotted_points(const PointSet& points, const Pose2& T_plot_points) {
  std::vector<Eigen::Vector2d> plotted;
  plotted.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    plotted.emplace_back(T_plot_points * Eigen::Vector2d(points.x_m[i], points.y_m[i]));
  }
  return plotted;
}

}  // namespace setsquare
