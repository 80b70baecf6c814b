// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "apps/setsquare/simulate/simulate.hpp"
#include "setsquare/drawing/svg_canvas.hpp"
#include "setsquare/report/nice_number.hpp"
#include "setsquare/report/palette.hpp"

namespace setsquare::app {
namespace {

using Eigen::Vector2d;

constexpr double kLongestSide_px = 1500.0;
constexpr double kMargin_px = 30.0;
constexpr double kHeader_px = 60.0;

struct MaterialStyle {
  Material material;
  const char* name;
  Color stroke;
  double width_px;
};
constexpr std::array kMaterialStyles = {
    MaterialStyle{Material::kClutter, "clutter", color(0xc2853a), 1.0},
    MaterialStyle{Material::kFurniture, "furniture", color(0x8b97a3), 1.0},
    MaterialStyle{Material::kGlass, "glass", color(0x35a7c9), 1.8},
    MaterialStyle{Material::kDoor, "door", color(0x8c4a2f), 1.8},
    MaterialStyle{Material::kPillar, "pillar", color(0x5b3f8c), 1.8},
    MaterialStyle{Material::kWall, "wall", palette::kWall, 1.8}};
constexpr Color kPersonColor = color(0xb0307a);

/// From the map, y up, to the picture, y down.
class Frame {
 public:
  explicit Frame(const Eigen::AlignedBox2d& box_m)
      : box_m_(box_m), px_per_m_(kLongestSide_px / std::max(box_m.sizes().maxCoeff(), 1e-3)) {}

  [[nodiscard]] Vector2d size_px() const {
    return px_per_m_ * box_m_.sizes() + Vector2d(2.0 * kMargin_px, 2.0 * kMargin_px + kHeader_px);
  }
  [[nodiscard]] Vector2d operator()(const Vector2d& p_m) const {
    return {kMargin_px + px_per_m_ * (p_m.x() - box_m_.min().x()),
            kMargin_px + kHeader_px + px_per_m_ * (box_m_.max().y() - p_m.y())};
  }
  [[nodiscard]] double px_per_m() const { return px_per_m_; }

 private:
  Eigen::AlignedBox2d box_m_;
  double px_per_m_;
};

Frame frame_around(const Building& world, const Trajectory& truth) {
  Eigen::AlignedBox2d box_m;
  for (const PlanSegment& segment : world.plan.segments) {
    box_m.extend(segment.start_m);
    box_m.extend(segment.end_m);
  }
  for (const StampedPose& stamped : truth) box_m.extend(stamped.pose.translation());
  return Frame(box_m);
}

/// All segments of a material as one broken line: cheap for a hundred thousand.
void draw_material(SvgCanvas& canvas,
                   const Frame& frame,
                   const FloorPlan& plan,
                   const MaterialStyle& style) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Vector2d> points;
  for (const PlanSegment& segment : plan.segments) {
    if (segment.material != style.material) continue;
    points.push_back(frame(segment.start_m));
    points.push_back(frame(segment.end_m));
    points.emplace_back(nan, nan);
  }
  if (points.empty()) return;
  canvas.polyline(points, {.stroke = style.stroke, .stroke_width_px = style.width_px});
}

void draw_people(SvgCanvas& canvas, const Frame& frame, const std::vector<Person>& people) {
  for (const Person& person : people) {
    canvas.line(frame(person.from_m),
                frame(person.to_m),
                {.stroke = kPersonColor, .stroke_width_px = 0.8, .dashes = "3 3"});
    canvas.circle(frame(person.from_m), 0.2 * frame.px_per_m(), {.fill = kPersonColor});
  }
}

void draw_path(SvgCanvas& canvas, const Frame& frame, const Trajectory& truth) {
  std::vector<Vector2d> points;
  points.reserve(truth.size());
  for (const StampedPose& stamped : truth) points.push_back(frame(stamped.pose.translation()));
  canvas.polyline(points, {.stroke = palette::kTracked, .stroke_width_px = 1.6});
  canvas.circle(points.front(), 5.0, {.fill = palette::kStart});
  canvas.circle(points.back(), 5.0, {.fill = palette::kEnd});
}

void draw_header(SvgCanvas& canvas,
                 const Frame& frame,
                 const Building& world,
                 const std::string& caption) {
  canvas.text({kMargin_px, 30.0}, caption, {.size_px = 16.0, .is_bold = true});
  double x_px = kMargin_px;
  const auto add_key = [&](const std::string& name, Color stroke) {
    canvas.line({x_px, 54.0}, {x_px + 22.0, 54.0}, {.stroke = stroke, .stroke_width_px = 3.0});
    canvas.text({x_px + 27.0, 58.0}, name);
    x_px += 45.0 + 7.0 * static_cast<double>(name.size());
  };
  for (auto style = kMaterialStyles.rbegin(); style != kMaterialStyles.rend(); ++style) {
    const auto& segments = world.plan.segments;
    const bool is_there = std::any_of(segments.begin(), segments.end(), [&](const auto& segment) {
      return segment.material == style->material;
    });
    if (is_there) add_key(style->name, style->stroke);
  }
  if (!world.people.empty()) add_key("people", kPersonColor);
  add_key("robot's true path", palette::kTracked);
  add_key("start", palette::kStart);
  add_key("end", palette::kEnd);
  const double bar_m = nice_number_below(200.0 / frame.px_per_m());
  const double bar_px = bar_m * frame.px_per_m();
  canvas.line({x_px, 54.0}, {x_px + bar_px, 54.0}, {.stroke = palette::kInk});
  canvas.text({x_px + bar_px + 5.0, 58.0}, svg_number(bar_m) + " m");
}

}  // namespace

std::string plan_picture(const Building& world,
                         const Trajectory& truth,
                         const std::string& caption) {
  const Frame frame = frame_around(world, truth);
  const Vector2d size_px = frame.size_px();
  SvgCanvas canvas(std::max(size_px.x(), 1100.0), size_px.y());
  canvas.rectangle({0.0, 0.0}, {canvas.width_px(), canvas.height_px()}, {.fill = palette::kPaper});
  for (const MaterialStyle& style : kMaterialStyles) {
    draw_material(canvas, frame, world.plan, style);
  }
  draw_people(canvas, frame, world.people);
  draw_path(canvas, frame, truth);
  draw_header(canvas, frame, world, caption);
  return canvas.document();
}

}  // namespace setsquare::app
