// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace setsquare {

/// "a, b, c". Not by fmt::join: <fmt/format.h>, which has it, costs each unit of sources seconds,
/// for all of fmt is compiled again; <fmt/core.h> leaves that to fmt's own library.
[[nodiscard]] std::string joined(std::span<const std::string> words,
                                 std::string_view separator = ", ");

}  // namespace setsquare
