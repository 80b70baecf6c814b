// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// The standard deviation of the ranges from beam to beam, in m; 0 where that cannot be told: too
/// few beams in a row return something, or the ranges differ as clutter does and not as noise does.
/// Taken from the second differences of ranges in a row, the small ones: walls hardly have any.
[[nodiscard]] double range_noise_m(const Scan& scan);

/// The ranges of a scan of a noisy scanner (range_noise_m() of 3.5 cm or more), each replaced by
/// that of a line through its neighbours within 4 degrees; nothing for other scans, which walls
/// are fitted to as they are. Ranges that are no returns, and steps from thing to thing, stay.
[[nodiscard]] std::optional<std::vector<double>> smoothed_ranges_m(const Scan& scan);

}  // namespace setsquare
