// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace setsquare::experiments {

/// A table for a terminal; the first column is words, the others are numbers.
struct TextTable {
  std::string caption;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

/// Caption, head and rows, one per line, in columns: the first to the left, the others to the
/// right.
[[nodiscard]] std::string text_of(const TextTable& table);

/// "99.53 %"; a dash where the share is not finite.
[[nodiscard]] std::string percent(double share, int num_decimals = 2);
/// A number with decimals; a dash where it is not finite.
[[nodiscard]] std::string number(double value, int num_decimals);

}  // namespace setsquare::experiments
