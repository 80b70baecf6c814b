// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace setsquare::experiments {

/// A cell of a table: words and, where it should look special, a class of the page's style ("good",
/// "bad", "faint").
struct Cell {
  std::string words;
  std::string style = {};
};

/// A table; the first column is words, the others are numbers.
struct Table {
  std::string caption;
  std::vector<std::string> head;
  std::vector<std::vector<Cell>> rows;
};

[[nodiscard]] std::string table_html(const Table& table);
/// The same for a terminal: caption, head and rows, one a line, in columns.
[[nodiscard]] std::string table_text(const Table& table);

/// <tag>words</tag> with the words escaped.
[[nodiscard]] std::string element(std::string_view tag, std::string_view words);
[[nodiscard]] std::string paragraph(std::string_view words);
/// How to get a section again: a line of the command in a box.
[[nodiscard]] std::string command_line(std::string_view words);
/// A part that opens on a click; `content` is HTML.
[[nodiscard]] std::string folding(std::string_view title, std::string_view content);
/// A figure with words below; `content` is HTML.
[[nodiscard]] std::string figure(std::string_view content, std::string_view caption);
/// A PNG file's bytes as an image element that needs no other file.
[[nodiscard]] std::string png_element(std::string_view png, std::string_view words);

/// "99.53 %"; a dash where the share is NaN.
[[nodiscard]] std::string percent(double share, int num_decimals = 2);
/// A number with decimals; a dash where it is NaN.
[[nodiscard]] std::string number(double value, int num_decimals);
[[nodiscard]] std::string number(std::size_t value);

/// Head and style, contents list of the sections, and the sections one after the other.
struct PageSection {
  std::string anchor;  ///< Name within the page, as `--only` takes it.
  std::string title;
  std::string content;  ///< HTML.
};
[[nodiscard]] std::string page_html(std::string_view title,
                                    std::string_view introduction,
                                    const std::vector<PageSection>& sections);

}  // namespace setsquare::experiments
