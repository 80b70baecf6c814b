// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <pugixml.hpp>
#include <vector>

#include "setsquare/sim/svg/path.hpp"

namespace setsquare {

/// The strokes of one basic shape or path; none for an element that is no shape. `T_map_user`
/// includes the element's own transform. Throws SvgFault.
[[nodiscard]] std::vector<SvgStroke> strokes_from_svg_shape(const pugi::xml_node& element,
                                                            const Eigen::Affine2d& T_map_user,
                                                            double tolerance_m);

}  // namespace setsquare
