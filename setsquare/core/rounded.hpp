// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace setsquare {

/// A number for files that people read: to the nearest 1e-6, what a log's own digits can support.
[[nodiscard]] inline double rounded(double value) { return std::round(value * 1e6) / 1e6; }

}  // namespace setsquare
