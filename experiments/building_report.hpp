// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "experiments/building_study.hpp"
#include "experiments/json.hpp"

namespace setsquare::experiments {

/// Summaries by class, by overlap, and every listed pair.
[[nodiscard]] Json json_from(const BuildingStudy& study);

/// The same as the content of a section of the page.
[[nodiscard]] std::string building_html(const BuildingStudy& study);

}  // namespace setsquare::experiments
