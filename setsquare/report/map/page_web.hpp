// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace setsquare {

// The files of web/, as they were when the library was built (cmake/embed_text.cmake).

/// web/map_report.html: the page's skeleton, with a mark such as "@SCRIPT@" for what goes in.
[[nodiscard]] std::string map_report_page();
/// web/map_report.css
[[nodiscard]] std::string map_report_style();
/// web/*.js, one after the other.
[[nodiscard]] std::string map_report_script();

}  // namespace setsquare
