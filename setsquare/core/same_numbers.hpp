// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace setsquare {

/// Whether two lists are the same, number by number. NaN, which stands for a range that was not
/// measured, is the same as NaN.
[[nodiscard]] inline bool are_same_numbers(std::span<const double> a, std::span<const double> b) {
  return std::ranges::equal(
      a, b, [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

}  // namespace setsquare
