// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/page_template.hpp"

#include <cassert>
#include <cstddef>

namespace setsquare {

std::string filled_page(const std::string& page, std::span<const PageMark> marks) {
  std::string filled;
  std::size_t done = 0;
  for (const auto& [mark, text] : marks) {
    const std::size_t place = page.find(mark, done);
    assert(place != std::string::npos);
    filled.append(page, done, place - done);
    filled += text;
    done = place + mark.size();
  }
  filled.append(page, done);
  return filled;
}

std::string json_within_script(std::string_view json) {
  std::string safe;
  for (const char letter : json) {
    if (letter == '<') {
      safe += "\\u003c";
    } else {
      safe += letter;
    }
  }
  return safe;
}

}  // namespace setsquare
