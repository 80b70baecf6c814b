// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// Share of the beams that return in both scans whose range is the same, to 0.1 m and 3 %: near 1
/// where the sensor stood still, people who pass by aside. Nothing where the scans have different
/// beams or fewer than 20 return in both.
[[nodiscard]] std::optional<double> unchanged_share(const Scan& before, const Scan& after);

}  // namespace setsquare
