// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "setsquare/report/map/page.hpp"

namespace setsquare {
/// The bytes in base64, padded.
[[nodiscard]] std::string base64(std::string_view bytes);

/// The nearest whole number of steps; 0 where the value is no number, and never beyond 2^50, which
/// a page's script can still count exactly.
[[nodiscard]] std::int64_t quantised(double value, double step);

/// Numbers for a page's script, small where neighbours differ little: each less the one before
/// (the first less 0), signs folded into the lowest bit (0, -1, 1, -2 ... become 0, 1, 2, 3 ...),
/// seven bits per byte, the lowest first, the high bit set where more follow; in base64.
[[nodiscard]] std::string packed(std::span<const std::int64_t> values);

/// The report as JSON for the page's script (web/unpack.js reads it): short texts as they are,
/// columns of numbers packed, the map as a PNG in base64. Safe within a script element: no '<'
/// stands in it, and no character outside ASCII.
[[nodiscard]] std::string map_report_json(const MapReport& report);

}  // namespace setsquare
