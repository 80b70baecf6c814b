// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace setsquare {

/// Weight of a residual in robust least squares after Geman and McClure: 1 at no residual, 1/4 at
/// the scale, falling with the fourth power. Both in the same unit.
[[nodiscard]] inline double geman_mcclure_weight(double residual, double scale) {
  const double q = residual / scale;
  const double root = 1.0 / (1.0 + q * q);
  return root * root;
}

}  // namespace setsquare
