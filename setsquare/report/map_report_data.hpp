// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "setsquare/report/map_report.hpp"

namespace setsquare {

/// The report as JSON for the page's script (web/unpack.js reads it): short texts as they are,
/// columns of numbers packed, the map as a PNG in base64. Safe within a script element: no '<'
/// stands in it, and no character outside ASCII.
[[nodiscard]] std::string map_report_json(const MapReport& report);

}  // namespace setsquare
