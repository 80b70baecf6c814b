// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/svg/shape.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "setsquare/core/angle.hpp"
#include "setsquare/sim/svg/scanner.hpp"

namespace setsquare {
namespace {

using Eigen::Vector2d;

std::optional<double> length_of(const pugi::xml_node& element, const char* attribute) {
  const pugi::xml_attribute found = element.attribute(attribute);
  if (!found) return std::nullopt;
  return length_from_svg(found.value());
}

double length_or_zero(const pugi::xml_node& element, const char* attribute) {
  return length_of(element, attribute).value_or(0.0);
}

SvgStroke stroke_from_points(const pugi::xml_node& element,
                             const Eigen::Affine2d& T_map_user,
                             bool is_closed) {
  SvgStroke stroke{{}, is_closed};
  SvgScanner points(element.attribute("points").value());
  while (!points.is_at_end()) {
    const double x = points.number();
    const double y = points.number();
    stroke.corners_m.emplace_back(T_map_user * Vector2d(x, y));
  }
  return stroke;
}

SvgStroke stroke_from_line(const pugi::xml_node& element, const Eigen::Affine2d& T_map_user) {
  const Vector2d from(length_or_zero(element, "x1"), length_or_zero(element, "y1"));
  const Vector2d to(length_or_zero(element, "x2"), length_or_zero(element, "y2"));
  return {{T_map_user * from, T_map_user * to}, false};
}

SvgStroke stroke_from_rectangle(const pugi::xml_node& element,
                                const Eigen::Affine2d& T_map_user,
                                double tolerance_m) {
  const Vector2d corner(length_or_zero(element, "x"), length_or_zero(element, "y"));
  const Vector2d size(length_or_zero(element, "width"), length_or_zero(element, "height"));
  if (size.minCoeff() < 0.0) throw SvgFault("a negative width or height");
  const auto given_rx = length_of(element, "rx");
  const auto given_ry = length_of(element, "ry");
  const double rx = std::clamp(given_rx.value_or(given_ry.value_or(0.0)), 0.0, 0.5 * size.x());
  const double ry = std::clamp(given_ry.value_or(given_rx.value_or(0.0)), 0.0, 0.5 * size.y());
  const Vector2d half = 0.5 * size;
  // The four corners in the order of growing angle; each a quarter of an ellipse.
  constexpr Eigen::Index kNumCorners = 4;
  const double signs[kNumCorners][2] = {{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}};
  SvgStroke stroke{{}, true};
  for (Eigen::Index i = 0; i < kNumCorners; ++i) {
    const Vector2d sign(signs[i][0], signs[i][1]);
    const Vector2d outer = corner + half + half.cwiseProduct(sign);
    if (rx == 0.0 || ry == 0.0) {
      stroke.corners_m.emplace_back(T_map_user * outer);
      continue;
    }
    const EllipseArc arc{T_map_user * Vector2d(outer - sign.cwiseProduct(Vector2d(rx, ry))),
                         T_map_user.linear() * Vector2d(rx, 0.0),
                         T_map_user.linear() * Vector2d(0.0, ry),
                         0.5 * kPi * static_cast<double>(i),
                         0.5 * kPi};
    stroke.corners_m.emplace_back(arc.center_m + std::cos(arc.start_rad) * arc.first_axis_m +
                                  std::sin(arc.start_rad) * arc.second_axis_m);
    append_arc(stroke.corners_m, arc, tolerance_m);
  }
  return stroke;
}

SvgStroke stroke_from_round(const pugi::xml_node& element,
                            const Vector2d& radii,
                            const Eigen::Affine2d& T_map_user,
                            double tolerance_m) {
  if (radii.minCoeff() < 0.0) throw SvgFault("a negative radius");
  const Vector2d center(length_or_zero(element, "cx"), length_or_zero(element, "cy"));
  return stroke_from_ellipse(center, radii, T_map_user, tolerance_m);
}

}  // namespace

std::vector<SvgStroke> strokes_from_svg_shape(const pugi::xml_node& element,
                                              const Eigen::Affine2d& T_map_user,
                                              double tolerance_m) {
  const std::string_view name = element.name();
  if (name == "line") return {stroke_from_line(element, T_map_user)};
  if (name == "polyline") return {stroke_from_points(element, T_map_user, false)};
  if (name == "polygon") return {stroke_from_points(element, T_map_user, true)};
  if (name == "rect") return {stroke_from_rectangle(element, T_map_user, tolerance_m)};
  if (name == "path") {
    return strokes_from_svg_path(element.attribute("d").value(), T_map_user, tolerance_m);
  }
  if (name == "circle") {
    const double radius = length_or_zero(element, "r");
    return {stroke_from_round(element, {radius, radius}, T_map_user, tolerance_m)};
  }
  if (name == "ellipse") {
    const Vector2d radii(length_or_zero(element, "rx"), length_or_zero(element, "ry"));
    return {stroke_from_round(element, radii, T_map_user, tolerance_m)};
  }
  return {};
}

}  // namespace setsquare
