// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiments/circuit_study.hpp"
#include "experiments/json.hpp"
#include "experiments/page_elements.hpp"

namespace setsquare::experiments {

[[nodiscard]] Json json_from(const CircuitStudy& study);
/// The part about the full mapper.
[[nodiscard]] std::string circuit_mapper_html(const CircuitStudy& study);
[[nodiscard]] std::string circuit_html(const CircuitStudy& study);
/// The maps of the full mapper over the seeds.
[[nodiscard]] Table mapper_table(const CircuitStudy& study);
/// A few lines for a terminal.
[[nodiscard]] std::string circuit_text(const CircuitStudy& study);

}  // namespace setsquare::experiments
