// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "experiments/tally.hpp"
#include "setsquare/core/pose2.hpp"

namespace setsquare::experiments {

/// Keys stay in the order in which they were written; NaN is written as null.
using Json = nlohmann::ordered_json;

/// {"mean": ..., "sigma": ..., "max": ..., "count": ...}, values times `unit`.
[[nodiscard]] Json json_from(const Spread& spread, double unit = 1.0);

/// Counts, shares and errors (m, deg) of a tally.
[[nodiscard]] Json json_from(const Tally& tally);

/// Status and error of one answer.
[[nodiscard]] Json json_from(const PairAnswer& answer);

/// {"x_m", "y_m", "heading_deg"}.
[[nodiscard]] Json json_from(const Pose2& pose);

}  // namespace setsquare::experiments
