// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <string_view>

namespace setsquare {

/// The map of an SVG `transform` attribute: matrix, translate, scale, rotate, skewX and skewY, the
/// last of a list applied first. Throws SvgFault.
[[nodiscard]] Eigen::Affine2d affine_from_svg_transform(std::string_view text);

}  // namespace setsquare
