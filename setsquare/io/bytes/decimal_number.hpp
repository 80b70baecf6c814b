// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

namespace setsquare {

/// Reads a number off the front of a text as std::from_chars does, whatever the locale: the same
/// double bit for bit and the same end, "nan", "inf" and exponents included. Faster for the short
/// decimals of which logs consist. Returns where the number ends, or null where the text begins
/// with none or with one that no double holds.
[[nodiscard]] const char* read_number(const char* first, const char* last, double& number);

/// A whole text as a number, a plus sign allowed; nothing where it is none.
[[nodiscard]] std::optional<double> decimal_from_text(std::string_view text);

}  // namespace setsquare
