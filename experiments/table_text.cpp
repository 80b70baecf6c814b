// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>

#include "experiments/page_elements.hpp"

namespace setsquare::experiments {
namespace {

/// The words of a cell, padded to the width of its column: the first to the left, others right.
std::string padded(const std::string& words, std::size_t column, std::size_t width) {
  const std::string padding(width - words.size(), ' ');
  return column == 0 ? words + padding : "  " + padding + words;
}

}  // namespace

std::string table_text(const Table& table) {
  std::vector<std::vector<std::string>> rows = {table.head};
  for (const std::vector<Cell>& cells : table.rows) {
    rows.emplace_back();
    for (const Cell& cell : cells) rows.back().push_back(cell.words);
  }
  std::vector<std::size_t> widths;
  for (const std::vector<std::string>& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text = table.caption.empty() ? "" : table.caption + "\n";
  for (const std::vector<std::string>& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += padded(row[i], i, widths[i]);
    text += line + "\n";
  }
  return text;
}

}  // namespace setsquare::experiments
