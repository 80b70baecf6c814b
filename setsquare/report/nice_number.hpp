// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace setsquare {

/// The greatest of 1, 2 and 5 times a power of ten that is not above a positive value.
[[nodiscard]] double nice_number_below(double value);

/// Evenly spaced round numbers in [low, high], at most `max_count` of them (at least 2), low <
/// high.
[[nodiscard]] std::vector<double> nice_ticks(double low, double high, int max_count);

/// Decimals needed to distinguish numbers that differ by this much.
[[nodiscard]] int decimals_for_step(double step);

}  // namespace setsquare
