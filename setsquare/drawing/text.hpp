// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace setsquare {
/// Which part of a line of text stands at its position.
enum class TextAnchor { kStart, kMiddle, kEnd };

/// A number with this many decimals (0 to 9), a point whatever the locale; "nan" and "inf" for
/// what is no number; never "-0.00".
[[nodiscard]] std::string fixed(double value, int num_decimals);

/// UTF-8 text with the five characters that XML reserves replaced. What XML 1.0 forbids (control
/// characters, bytes that are no UTF-8) becomes U+FFFD, the replacement character.
[[nodiscard]] std::string escape_xml(std::string_view text);

}  // namespace setsquare
