// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "setsquare/map/map.hpp"

namespace setsquare::app {

/// The verdict on a map and its doubts, a line each, numbered as on map.png and the page. Empty for
/// a map that was not audited.
[[nodiscard]] std::string verdict_text(const Map& map);

}  // namespace setsquare::app
