// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "setsquare/sim/floor_plan.hpp"

namespace setsquare {

struct SvgPlanParams {
  double m_per_unit = 1.0;      ///< Metres that one user unit of the drawing stands for.
  double flattening_m = 0.005;  ///< Curves become chords no farther than this from them.

  /// Throws ParameterError naming the field that is out of its domain.
  void validate() const;
};

/// A floor plan drawn as SVG, and the way through it where the drawing has one.
struct SvgPlan {
  FloorPlan plan;
  std::vector<Eigen::Vector2d> route_m;  ///< Corners of the shape with id "route"; else empty.
};

/// Reads a floor plan from an SVG document: line, polyline, polygon, rect, circle, ellipse and path
/// (strokes only, whatever the fill), inside groups, with `transform` of both. The map's frame is
/// the drawing's with y turned up: x_m = m_per_unit x, y_m = -m_per_unit y, in user units of the
/// outermost element. The attribute `data-material`, or else a word of `class`, of the shape or of
/// the nearest group that has one names the material: wall (where none does), door, glass, pillar,
/// furniture, clutter. What is not displayed and what stands in defs and the like is left out; text
/// and images are no walls. Throws FormatError with the line where the text is not well-formed,
/// uses what cannot be followed (`use`, units, unknown materials), lies beyond 10 km, holds no
/// line, more than 500 000 lines or more than 16 MB. `name` stands in messages for the path.
[[nodiscard]] SvgPlan floor_plan_from_svg(std::string_view svg,
                                          const std::string& name,
                                          const SvgPlanParams& params = {});

}  // namespace setsquare
