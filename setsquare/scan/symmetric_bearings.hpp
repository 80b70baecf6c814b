// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Shared by logs that state no angles and by the Python package.
#pragma once

#include <cstddef>

namespace setsquare {

/// The angle from a beam to the next, in rad, where only the sweep's field of view is known: an odd
/// number of beams has one at either end of it (181 over 180 degrees), an even number none at its
/// end (180 over 180, 360 over 360). The field of view for one beam or none.
[[nodiscard]] inline double symmetric_step_rad(double field_of_view_rad, std::size_t num_beams) {
  if (num_beams < 2) return field_of_view_rad;
  const std::size_t num_steps = num_beams % 2 == 1 ? num_beams - 1 : num_beams;
  return field_of_view_rad / static_cast<double>(num_steps);
}

}  // namespace setsquare
