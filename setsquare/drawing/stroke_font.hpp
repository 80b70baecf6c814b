// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

namespace setsquare {

/// A line of a drawing: points joined in order; a single point is a dot.
using Stroke = std::vector<Eigen::Vector2d>;

/// The strokes of a line of ASCII text in capital heights: (0, 0) is the start of the baseline, x
/// to the right, y up, a capital letter is 1 high. Characters without a glyph become a box.
[[nodiscard]] std::vector<Stroke> strokes_of_text(std::string_view text);

/// Width of that text in capital heights, from the first stroke to the last.
[[nodiscard]] double text_width(std::string_view text);

}  // namespace setsquare
