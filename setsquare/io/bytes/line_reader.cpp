// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/line_reader.hpp"

#include <algorithm>

namespace setsquare {

void LineReader::skip_rest_of_line() {
  for (;;) {
    const std::string_view bytes = input_.available();
    const std::size_t end = bytes.find('\n');
    if (end != std::string_view::npos) {
      input_.consume(end + 1);
      return;
    }
    input_.consume(bytes.size());
    if (!input_.fill()) return;
  }
}

std::optional<std::string_view> LineReader::next() {
  input_.consume(num_returned_bytes_);
  num_returned_bytes_ = 0;
  if (is_too_long_) skip_rest_of_line();
  is_too_long_ = false;
  std::size_t num_searched = 0;
  std::size_t end = 0;
  while ((end = input_.available().find('\n', num_searched)) == std::string_view::npos) {
    num_searched = input_.available().size();
    if (num_searched > kMaxLineBytes || !input_.fill()) break;
  }
  std::string_view line = input_.available();
  has_end_ = end != std::string_view::npos;
  if (end == std::string_view::npos) {
    if (line.empty()) return std::nullopt;
    is_too_long_ = line.size() > kMaxLineBytes;
    has_end_ = is_too_long_;  // not seen, but the text goes on
    num_returned_bytes_ = line.size();
  } else {
    num_returned_bytes_ = end + 1;
    line = line.substr(0, end);
    // The buffer may hold more than the limit when the end comes into view.
    if (line.size() > kMaxLineBytes) {
      is_too_long_ = true;
      num_returned_bytes_ = kMaxLineBytes;
    }
  }
  ++line_number_;
  if (is_too_long_) line = line.substr(0, kMaxLineBytes);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace setsquare
