// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/bytes/text_beginning.hpp"

#include <string_view>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
constexpr std::string_view kLfsPointer = "version https://git-lfs.github.com/spec/";

/// With a byte order mark, or ASCII letters between zeros.
bool is_utf16(std::string_view beginning) {
  if (beginning.starts_with("\xff\xfe") || beginning.starts_with("\xfe\xff")) return true;
  constexpr std::size_t kNumLooked = 8;
  if (beginning.size() < kNumLooked) return false;
  const auto is_ascii = [](char c) { return (c >= ' ' && c <= '~') || (c >= '\t' && c <= '\r'); };
  const auto has_ascii_at = [&](std::size_t first) {
    for (std::size_t i = 0; i < kNumLooked; i += 2) {
      if (!is_ascii(beginning[i + first]) || beginning[i + 1 - first] != '\0') return false;
    }
    return true;
  };
  return has_ascii_at(0) || has_ascii_at(1);
}

}  // namespace

void begin_text(InputBuffer& input, const std::string& name) {
  input.ensure(kLfsPointer.size());
  const std::string_view beginning = input.available();
  if (beginning.starts_with(kByteOrderMark)) input.consume(kByteOrderMark.size());
  if (beginning.starts_with(kLfsPointer)) {
    throw FormatError(name, "", "a Git LFS pointer in place of the file: fetch it by git lfs pull");
  }
  if (is_utf16(beginning)) throw FormatError(name, "", "text in UTF-16: save it as UTF-8");
}

}  // namespace setsquare
