// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Stamps in text, to the nanosecond.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "setsquare/core/timestamp.hpp"

namespace setsquare {

/// Decimal seconds with six decimals, with nine where the microsecond does not state the stamp.
[[nodiscard]] std::string exact_text(Timestamp stamp);

/// Reads a stamp written in units of 10^-num_decimals s (0, 3, 6 or 9): exactly from plain
/// decimals, digits below the nanosecond rounded; with an exponent ("1.3e+09") as exactly as a
/// double has it. Nothing where the text is no number or the stamp is beyond kMaxStamp_ns.
[[nodiscard]] std::optional<Timestamp> stamp_from_text(std::string_view text, int num_decimals = 0);

}  // namespace setsquare
