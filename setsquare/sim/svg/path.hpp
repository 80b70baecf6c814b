// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <string_view>
#include <vector>

#include "setsquare/sim/svg/flattened_curve.hpp"

namespace setsquare {

/// One stroke of the pen. What is closed does not repeat its first corner.
struct SvgStroke {
  Corners corners_m;
  bool is_closed = false;
};

/// The strokes of an SVG path's `d` (M L H V C S Q T A Z, absolute and relative), mapped by
/// `T_map_user` from user units to m; curves flattened to `tolerance_m`. Throws SvgFault.
[[nodiscard]] std::vector<SvgStroke> strokes_from_svg_path(std::string_view d,
                                                           const Eigen::Affine2d& T_map_user,
                                                           double tolerance_m);

/// The ellipse about `center` with the two radii, in user units, from the x axis around.
[[nodiscard]] SvgStroke stroke_from_ellipse(const Eigen::Vector2d& center,
                                            const Eigen::Vector2d& radii,
                                            const Eigen::Affine2d& T_map_user,
                                            double tolerance_m);

}  // namespace setsquare
