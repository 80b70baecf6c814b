// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "apps/setsquare/reference/command_tree.hpp"

namespace setsquare::app {

/// The manual page of a command, for man(1): section 1.
[[nodiscard]] std::string manual_page(const Command& command);

/// "setsquare-evaluate-ate.1": its file's name.
[[nodiscard]] std::string manual_file_name(const Command& command);

}  // namespace setsquare::app
