// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/svg/floor_plan_svg.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <Eigen/Geometry>
#include <optional>
#include <pugixml.hpp>

#include "setsquare/core/error.hpp"
#include "setsquare/sim/svg/scanner.hpp"
#include "setsquare/sim/svg/shape.hpp"
#include "setsquare/sim/svg/transform.hpp"

namespace setsquare {
namespace {

constexpr int kMaxDepth = 200;
/// Drawings of whole buildings have some ten thousand lines. At these limits reading and simulating
/// take some 300 MB.
constexpr std::size_t kMaxSegments = 500'000;
constexpr std::size_t kMaxBytes = std::size_t{16} << 20;
constexpr double kFarthestCorner_m = 10'000.0;

struct NamedMaterial {
  std::string_view name;
  Material material;
};
constexpr std::array<NamedMaterial, 6> kMaterials = {{{"wall", Material::kWall},
                                                      {"door", Material::kDoor},
                                                      {"glass", Material::kGlass},
                                                      {"pillar", Material::kPillar},
                                                      {"furniture", Material::kFurniture},
                                                      {"clutter", Material::kClutter}}};

std::optional<Material> material_from(std::string_view name) {
  const auto found = std::find_if(kMaterials.begin(), kMaterials.end(), [name](const auto& known) {
    return known.name == name;
  });
  if (found == kMaterials.end()) return std::nullopt;
  return found->material;
}

/// What the element itself says of its material.
std::optional<Material> stated_material(const pugi::xml_node& element) {
  if (const pugi::xml_attribute stated = element.attribute("data-material")) {
    const auto material = material_from(stated.value());
    if (!material)
      throw SvgFault("data-material is none of wall door glass pillar furniture clutter");
    return material;
  }
  std::string_view words = element.attribute("class").value();
  while (!words.empty()) {
    const std::size_t end = std::min(words.find_first_of(" \t\r\n"), words.size());
    if (const auto material = material_from(words.substr(0, end))) return material;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return std::nullopt;
}

bool is_displayed(const pugi::xml_node& element) {
  if (std::string_view(element.attribute("display").value()) == "none") return false;
  std::string style = element.attribute("style").value();
  std::erase(style, ' ');
  return style.find("display:none") == std::string::npos;
}

bool is_never_drawn(std::string_view name) {
  constexpr std::array<std::string_view, 9> kNames = {"defs",
                                                      "symbol",
                                                      "clipPath",
                                                      "mask",
                                                      "pattern",
                                                      "marker",
                                                      "linearGradient",
                                                      "radialGradient",
                                                      "filter"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

/// "line 12" of a byte offset.
std::string line_at(std::string_view text, std::ptrdiff_t offset) {
  const auto end = text.begin() + std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(text));
  return fmt::format("line {}", 1 + std::count(text.begin(), end, '\n'));
}

/// What an element takes over from those around it.
struct Inherited {
  Eigen::Affine2d T_map_user;
  Material material = Material::kWall;
  int depth = 0;
};

/// Walks the document and gathers the plan; `last_offset` is its place when a fault was
/// found.
class SvgWalker {
 public:
  explicit SvgWalker(double flattening_m) : flattening_m_(flattening_m) {}

  void walk(const pugi::xml_node& element, const Inherited& outer);

  [[nodiscard]] SvgPlan take() { return std::move(plan_); }
  [[nodiscard]] std::ptrdiff_t last_offset() const { return last_offset_; }

 private:
  void add(const pugi::xml_node& element, const Inherited& here);
  void add_route(const std::vector<SvgStroke>& strokes);

  double flattening_m_;
  SvgPlan plan_;
  std::ptrdiff_t last_offset_ = 0;
};

void require_near(const Corners& corners_m) {
  for (const Eigen::Vector2d& corner_m : corners_m) {
    // NaN is not near either.
    if (!(corner_m.cwiseAbs().maxCoeff() <= kFarthestCorner_m)) {
      throw SvgFault("a point lies beyond 10 km (is the scale right?)");
    }
  }
}

void SvgWalker::add_route(const std::vector<SvgStroke>& strokes) {
  if (strokes.size() != 1 || strokes[0].corners_m.size() < 2) {
    throw SvgFault("the route must be one line of two points or more");
  }
  plan_.route_m = strokes[0].corners_m;
  if (strokes[0].is_closed) plan_.route_m.push_back(plan_.route_m.front());
}

void SvgWalker::add(const pugi::xml_node& element, const Inherited& here) {
  const std::vector<SvgStroke> strokes =
      strokes_from_svg_shape(element, here.T_map_user, flattening_m_);
  for (const SvgStroke& stroke : strokes) require_near(stroke.corners_m);
  if (!strokes.empty() && std::string_view(element.attribute("id").value()) == "route") {
    return add_route(strokes);
  }
  for (const SvgStroke& stroke : strokes) {
    add_polyline(plan_.plan, stroke.corners_m, here.material, stroke.is_closed);
  }
  if (plan_.plan.segments.size() > kMaxSegments) throw SvgFault("more than 500 000 lines");
}

void SvgWalker::walk(const pugi::xml_node& element, const Inherited& outer) {
  last_offset_ = element.offset_debug();
  const std::string_view name = element.name();
  if (is_never_drawn(name) || !is_displayed(element)) return;
  if (name == "use") throw SvgFault("<use> is not followed: draw the shape where it stands");
  if (outer.depth > kMaxDepth) throw SvgFault("groups nested too deeply");
  const Inherited here{
      outer.T_map_user * affine_from_svg_transform(element.attribute("transform").value()),
      stated_material(element).value_or(outer.material),
      outer.depth + 1};
  add(element, here);
  for (const pugi::xml_node& child : element.children()) {
    if (child.type() == pugi::node_element) walk(child, here);
  }
}

void remove_pointlike(FloorPlan& plan) {
  std::erase_if(plan.segments, [](const PlanSegment& segment) {
    return (segment.end_m - segment.start_m).norm() < 1e-9;
  });
}

}  // namespace

void SvgPlanParams::validate() const {
  if (!(m_per_unit > 0.0) || !std::isfinite(m_per_unit)) {
    throw ParameterError("m_per_unit", "must be above 0");
  }
  if (!(flattening_m > 0.0)) throw ParameterError("flattening_m", "must be above 0");
}

SvgPlan floor_plan_from_svg(std::string_view svg,
                            const std::string& name,
                            const SvgPlanParams& params) {
  params.validate();
  if (svg.size() > kMaxBytes) throw FormatError(name, "", "more than 16 MB of SVG");
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(svg.data(), svg.size());
  if (!parsed) throw FormatError(name, line_at(svg, parsed.offset), parsed.description());
  const pugi::xml_node root = document.document_element();
  if (std::string_view(root.name()) != "svg") throw FormatError(name, "", "not an SVG document");
  SvgWalker walker(params.flattening_m);
  try {
    const Eigen::Affine2d T_map_user(Eigen::Scaling(params.m_per_unit, -params.m_per_unit));
    walker.walk(root, {T_map_user, Material::kWall, 0});
  } catch (const SvgFault& fault) {
    throw FormatError(name, line_at(svg, walker.last_offset()), fault.what());
  }
  SvgPlan plan = walker.take();
  remove_pointlike(plan.plan);
  if (plan.plan.segments.empty()) throw FormatError(name, "", "no wall: not one line is drawn");
  return plan;
}

}  // namespace setsquare
