// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/text_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace setsquare::experiments {

std::string text_of(const TextTable& table) {
  std::vector<std::vector<std::string>> lines = {table.head};
  lines.insert(lines.end(), table.rows.begin(), table.rows.end());
  std::vector<std::size_t> widths(table.head.size(), 0);
  for (const std::vector<std::string>& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  std::string text = table.caption.empty() ? "" : table.caption + "\n";
  for (const std::vector<std::string>& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      text += i == 0 ? fmt::format("{:<{}}", line[i], widths[i])
                     : fmt::format("  {:>{}}", line[i], widths[i]);
    }
    text += "\n";
  }
  return text;
}

std::string percent(double share, int num_decimals) {
  return std::isfinite(share) ? fmt::format("{:.{}f} %", 100.0 * share, num_decimals) : "-";
}

std::string number(double value, int num_decimals) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, num_decimals) : "-";
}

}  // namespace setsquare::experiments
