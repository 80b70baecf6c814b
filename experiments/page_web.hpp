// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace setsquare {

// The files of web/, as they were when the program was built (cmake/embed_text.cmake). A
// separate header, since the source that the build writes includes it, too.

/// web/paper.html: the page's skeleton, with a mark such as "@SCRIPT@" for what goes in.
[[nodiscard]] std::string paper_page();
/// web/paper.css
[[nodiscard]] std::string paper_style();
/// web/*.js, one after the other.
[[nodiscard]] std::string paper_script();

}  // namespace setsquare
