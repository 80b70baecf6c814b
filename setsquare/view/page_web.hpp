// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The parts of the live view's page, put in at build time: setsquare/view/web and what it shares
// with setsquare/report/web.
#pragma once

#include <string>

namespace setsquare {

/// With the marks @STYLE@ and @SCRIPT@.
[[nodiscard]] std::string live_page();
[[nodiscard]] std::string live_style();
[[nodiscard]] std::string live_script();

}  // namespace setsquare
