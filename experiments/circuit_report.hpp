// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiments/circuit_study.hpp"
#include "experiments/json.hpp"

namespace setsquare::experiments {

[[nodiscard]] Json json_from(const CircuitStudy& study);
[[nodiscard]] std::string circuit_html(const CircuitStudy& study);
/// A few lines for a terminal.
[[nodiscard]] std::string circuit_text(const CircuitStudy& study);

}  // namespace setsquare::experiments
