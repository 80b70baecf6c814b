// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace setsquare::testing {

/// What keeps a text from being one well-formed XML element (tags closed in order, attributes
/// quoted and named once, only known entities), with the place; nothing where it is well-formed.
/// Knows elements, attributes, text, the XML declaration and the HTML doctype: what our pictures
/// and pages use.
[[nodiscard]] std::optional<std::string> xml_fault(std::string_view text);

}  // namespace setsquare::testing
