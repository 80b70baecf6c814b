// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/core/joined.hpp"

#include <cstddef>

namespace setsquare {

std::string joined(std::span<const std::string> words, std::string_view separator) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (k > 0) text += separator;
    text += words[k];
  }
  return text;
}

}  // namespace setsquare
