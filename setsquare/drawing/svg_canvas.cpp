// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/drawing/svg_canvas.hpp"

#include <fmt/core.h>

#include <cmath>

#include "setsquare/drawing/text.hpp"

namespace setsquare {
namespace {

std::string attribute(std::string_view name, std::string_view value) {
  return fmt::format(" {}=\"{}\"", name, escape_xml(value));
}

std::string attribute(std::string_view name, double value) {
  return attribute(name, svg_number(value));
}

std::string hexadecimal(Color value) {
  return fmt::format("#{:02x}{:02x}{:02x}", value.red, value.green, value.blue);
}

std::string attributes_of(const ShapeStyle& style) {
  std::string text = attribute("fill", style.fill ? hexadecimal(*style.fill) : "none");
  if (style.stroke) {
    text += attribute("stroke", hexadecimal(*style.stroke));
    text += attribute("stroke-width", style.stroke_width_px);
    text += attribute("stroke-linejoin", "round");
    if (!style.dashes.empty()) text += attribute("stroke-dasharray", style.dashes);
  }
  if (style.opacity < 1.0) text += attribute("opacity", style.opacity);
  return text;
}

std::string point_of_path(char command, const Eigen::Vector2d& point) {
  return fmt::format("{}{} {}", command, svg_number(point.x()), svg_number(point.y()));
}

}  // namespace

std::string svg_number(double value) {
  if (!(std::abs(value) < 1e9)) return "0";
  std::string text = fixed(value, 2);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

SvgCanvas::SvgCanvas(double width_px, double height_px)
    : width_px_(width_px), height_px_(height_px) {}

void SvgCanvas::rectangle(const Eigen::Vector2d& corner,
                          const Eigen::Vector2d& size,
                          const ShapeStyle& style) {
  body_ += "<rect" + attribute("x", corner.x()) + attribute("y", corner.y()) +
           attribute("width", size.x()) + attribute("height", size.y()) + attributes_of(style) +
           "/>\n";
}

void SvgCanvas::circle(const Eigen::Vector2d& centre, double radius_px, const ShapeStyle& style) {
  body_ += "<circle" + attribute("cx", centre.x()) + attribute("cy", centre.y()) +
           attribute("r", radius_px) + attributes_of(style) + "/>\n";
}

void SvgCanvas::line(const Eigen::Vector2d& from,
                     const Eigen::Vector2d& to,
                     const ShapeStyle& style) {
  body_ += "<line" + attribute("x1", from.x()) + attribute("y1", from.y()) +
           attribute("x2", to.x()) + attribute("y2", to.y()) + attributes_of(style) + "/>\n";
}

void SvgCanvas::polyline(std::span<const Eigen::Vector2d> points, const ShapeStyle& style) {
  std::string path;
  bool is_broken = true;
  for (const Eigen::Vector2d& point : points) {
    if (point.allFinite()) path += point_of_path(is_broken ? 'M' : 'L', point);
    is_broken = !point.allFinite();
  }
  if (path.empty()) return;
  body_ += "<path" + attribute("d", path) + attributes_of(style) + "/>\n";
}

void SvgCanvas::dots(std::span<const Eigen::Vector2d> centres,
                     double radius_px,
                     Color value,
                     double opacity) {
  std::string path;
  for (const Eigen::Vector2d& centre : centres) {
    if (centre.allFinite()) path += point_of_path('M', centre) + "h0";
  }
  if (path.empty()) return;
  const ShapeStyle style = {.fill = {},
                            .stroke = value,
                            .stroke_width_px = 2.0 * radius_px,
                            .opacity = opacity,
                            .dashes = {}};
  body_ += "<path" + attribute("d", path) + attributes_of(style) +
           attribute("stroke-linecap", "round") + "/>\n";
}

void SvgCanvas::text(const Eigen::Vector2d& position,
                     std::string_view words,
                     const TextStyle& style) {
  constexpr std::string_view kAnchors[] = {"start", "middle", "end"};
  body_ += "<text" + attribute("x", position.x()) + attribute("y", position.y()) +
           attribute("font-size", style.size_px) + attribute("fill", hexadecimal(style.fill)) +
           attribute("text-anchor", kAnchors[static_cast<std::size_t>(style.anchor)]);
  if (style.is_bold) body_ += attribute("font-weight", "bold");
  if (style.rotation_deg != 0.0) {
    body_ += attribute("transform",
                       fmt::format("rotate({} {} {})",
                                   svg_number(style.rotation_deg),
                                   svg_number(position.x()),
                                   svg_number(position.y())));
  }
  body_ += fmt::format(">{}</text>\n", escape_xml(words));
}

void SvgCanvas::begin_clip(const Eigen::Vector2d& corner, const Eigen::Vector2d& size) {
  // A nested svg element clips to its viewport and needs no id, which two pictures could share.
  const std::string box = fmt::format("{} {} {} {}",
                                      svg_number(corner.x()),
                                      svg_number(corner.y()),
                                      svg_number(size.x()),
                                      svg_number(size.y()));
  body_ += "<svg" + attribute("x", corner.x()) + attribute("y", corner.y()) +
           attribute("width", size.x()) + attribute("height", size.y()) +
           attribute("viewBox", box) + attribute("overflow", "hidden") + ">\n";
}

void SvgCanvas::end_clip() { body_ += "</svg>\n"; }

void SvgCanvas::place(const SvgCanvas& other, const Eigen::Vector2d& corner) {
  body_ += fmt::format(
      "<svg{}{}>\n{}</svg>\n", attribute("x", corner.x()), attribute("y", corner.y()), other.body_);
}

std::string SvgCanvas::element(std::string_view css_class) const {
  const std::string width = svg_number(width_px_);
  const std::string height = svg_number(height_px_);
  return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\"{}{}{}{}{}>\n{}</svg>\n",
                     css_class.empty() ? "" : attribute("class", css_class),
                     attribute("width", width),
                     attribute("height", height),
                     attribute("viewBox", fmt::format("0 0 {} {}", width, height)),
                     attribute("font-family", "Helvetica, Arial, Liberation Sans, sans-serif"),
                     body_);
}

std::string SvgCanvas::document() const {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + element();
}

}  // namespace setsquare
