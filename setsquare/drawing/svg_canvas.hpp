// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "setsquare/drawing/color.hpp"
#include "setsquare/drawing/text.hpp"

namespace setsquare {

/// How a shape looks; one with neither fill nor stroke is not seen.
struct ShapeStyle {
  std::optional<Color> fill = std::nullopt;
  std::optional<Color> stroke = std::nullopt;
  double stroke_width_px = 1.0;
  double opacity = 1.0;
  std::string dashes = {};  ///< SVG's stroke-dasharray, such as "4 3"; empty for a solid line.
};

struct TextStyle {
  double size_px = 12.0;
  Color fill = color(0x222222);
  TextAnchor anchor = TextAnchor::kStart;
  bool is_bold = false;
  double rotation_deg = 0.0;  ///< Clockwise about the position, as SVG turns.
};

/// A number as SVG wants it: at most two decimals, a point whatever the locale, no trailing zeros.
[[nodiscard]] std::string svg_number(double value);

/// Builds an SVG picture; x to the right, y down, in pixels.
class SvgCanvas {
 public:
  SvgCanvas(double width_px, double height_px);

  void rectangle(const Eigen::Vector2d& corner,
                 const Eigen::Vector2d& size,
                 const ShapeStyle& style);
  void circle(const Eigen::Vector2d& centre, double radius_px, const ShapeStyle& style);
  void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const ShapeStyle& style);
  /// Points that are not finite break the line.
  void polyline(std::span<const Eigen::Vector2d> points, const ShapeStyle& style);
  /// One path of many equal dots: cheap for a thousand points.
  void dots(std::span<const Eigen::Vector2d> centres,
            double radius_px,
            Color value,
            double opacity);
  void text(const Eigen::Vector2d& position, std::string_view words, const TextStyle& style = {});
  /// What follows, until end_clip, is seen inside the rectangle only.
  void begin_clip(const Eigen::Vector2d& corner, const Eigen::Vector2d& size);
  void end_clip();
  /// Draws another canvas with its upper left corner here.
  void place(const SvgCanvas& other, const Eigen::Vector2d& corner);

  [[nodiscard]] double width_px() const { return width_px_; }
  [[nodiscard]] double height_px() const { return height_px_; }

  /// The whole picture as an XML document, or, to stand inside an HTML page, its svg element alone,
  /// of a class of the page's style where one is named.
  [[nodiscard]] std::string document() const;
  [[nodiscard]] std::string element(std::string_view css_class = "") const;

 private:
  double width_px_;
  double height_px_;
  std::string body_;
};

}  // namespace setsquare
