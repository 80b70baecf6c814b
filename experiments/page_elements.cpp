// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/page_elements.hpp"

#include <cmath>
#include <cstdint>

#include "setsquare/drawing/text.hpp"

namespace setsquare::experiments {
namespace {

std::string row_html(const std::vector<Cell>& cells) {
  std::string row = "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string_view tag = i == 0 ? "th" : "td";
    const Cell& cell = cells[i];
    row += joined({"<", tag});
    if (i == 0) row += " scope=\"row\"";
    if (!cell.style.empty()) row += joined({" class=\"", cell.style, "\""});
    row += joined({">", escape_xml(cell.words), "</", tag, ">"});
  }
  return row + "</tr>\n";
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t triple = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_inside = i + k < bytes.size();
      triple = triple << 8 | (is_inside ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const bool is_inside = i + k <= bytes.size();
      text += is_inside ? kDigits[triple >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

}  // namespace

std::string table_html(const Table& table) {
  std::string html = "<div class=\"wide\"><table>\n";
  if (!table.caption.empty()) html += element("caption", table.caption);
  html += "<thead><tr>";
  for (const std::string& words : table.head) {
    html += joined({"<th scope=\"col\">", escape_xml(words), "</th>"});
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const std::vector<Cell>& row : table.rows) html += row_html(row);
  return html + "</tbody></table></div>\n";
}

std::string element(std::string_view tag, std::string_view words) {
  return joined({"<", tag, ">", escape_xml(words), "</", tag, ">\n"});
}

std::string paragraph(std::string_view words) { return element("p", words); }

std::string command_line(std::string_view words) {
  return joined({"<pre><code>", escape_xml(words), "</code></pre>\n"});
}

std::string folding(std::string_view title, std::string_view content) {
  return joined(
      {"<details>\n<summary>", escape_xml(title), "</summary>\n", content, "</details>\n"});
}

std::string figure(std::string_view content, std::string_view caption) {
  return joined({"<figure>\n", content, element("figcaption", caption), "</figure>\n"});
}

std::string png_element(std::string_view png, std::string_view words) {
  return joined(
      {"<img alt=\"", escape_xml(words), "\" src=\"data:image/png;base64,", base64(png), "\"/>\n"});
}

std::string percent(double share, int num_decimals) {
  return std::isfinite(share) ? fixed(100.0 * share, num_decimals) + " %" : "-";
}

std::string number(double value, int num_decimals) {
  return std::isfinite(value) ? fixed(value, num_decimals) : "-";
}

std::string number(std::size_t value) { return std::to_string(value); }

}  // namespace setsquare::experiments
