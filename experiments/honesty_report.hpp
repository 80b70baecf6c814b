// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiments/honesty_study.hpp"
#include "experiments/json.hpp"

namespace setsquare::experiments {

[[nodiscard]] Json json_from(const HonestyStudy& study);
[[nodiscard]] std::string honesty_html(const HonestyStudy& study);
/// A few lines for a terminal.
[[nodiscard]] std::string honesty_text(const HonestyStudy& study);

}  // namespace setsquare::experiments
