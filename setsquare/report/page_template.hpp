// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace setsquare {

/// A mark of a page, such as @TITLE@, and the text that takes its place.
using PageMark = std::pair<std::string_view, std::string>;

/// The page with each mark replaced, once. `marks` are in the order in which they stand in the
/// page, so that no text that was put in is taken for a mark; each of them is there.
[[nodiscard]] std::string filled_page(const std::string& page, std::span<const PageMark> marks);

/// JSON that may stand within a script element: no '<' is left in it.
[[nodiscard]] std::string json_within_script(std::string_view json);

}  // namespace setsquare
