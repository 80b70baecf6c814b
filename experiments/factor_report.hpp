// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiments/factor_study.hpp"
#include "experiments/json.hpp"

namespace setsquare::experiments {

[[nodiscard]] Json json_from(const FactorStudy& study);
[[nodiscard]] std::string factor_html(const FactorStudy& study);
/// A few lines for a terminal.
[[nodiscard]] std::string factor_text(const FactorStudy& study);

}  // namespace setsquare::experiments
