// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <string>
#include <string_view>
#include <vector>

#include "setsquare/drawing/text.hpp"
#include "setsquare/report/match/report.hpp"
#include "setsquare/report/match/sections.hpp"

namespace setsquare {
namespace {

// On a phone a panel takes the whole width; one that would become too small to read keeps a least
// width, and its figure scrolls.
constexpr std::string_view kStyle = R"css(
body { font: 15px/1.5 Helvetica, Arial, "Liberation Sans", sans-serif; color: #1f2933;
       max-width: 1320px; margin: 32px auto; padding: 0 24px; }
h1 { font-size: 26px; line-height: 1.25; margin: 0; }
h2 { font-size: 18px; margin: 40px 0 2px; }
p.remark { color: #64707d; margin: 2px 0 12px; overflow-wrap: anywhere; }
.status { display: inline-block; padding: 3px 14px; border-radius: 14px; color: #ffffff;
          font-weight: bold; }
.matched { background: #12805c; }
.ambiguous, .degenerate { background: #b26a00; }
.no_overlap, .too_few_points, .rejected { background: #d02a3c; }
ul.evidence { padding-left: 20px; }
.figure { display: flex; flex-wrap: wrap; overflow-x: auto; }
.figure svg { flex: 0 0 auto; max-width: 100%; height: auto; }
.table { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: 14px; }
th, td { padding: 4px 14px 4px 0; border-bottom: 1px solid #e3e7eb; text-align: right;
         white-space: nowrap; }
th:last-child, td:last-child { text-align: left; padding-left: 18px; }
table.words th, table.words td { text-align: left; padding-left: 0; }
tr.marked td { color: #12805c; font-weight: bold; }
.words tr.marked td { color: #b03040; }
@media (max-width: 760px) {
  body { margin: 16px auto; padding: 0 12px; }
  h1 { font-size: 22px; }
  .figure svg.half { min-width: 480px; }
  .figure svg.wide { min-width: 760px; }
  table.words td { white-space: normal; min-width: 8em; }
}
)css";

std::string element(std::string_view tag, std::string_view words) {
  return fmt::format("<{0}>{1}</{0}>\n", tag, escape_xml(words));
}

std::string table_row(const std::vector<std::string>& cells, std::string_view tag, bool is_marked) {
  std::string row = is_marked ? "<tr class=\"marked\">" : "<tr>";
  for (const std::string& cell : cells) row += element(tag, cell);
  return row + "</tr>\n";
}

std::string html_table(const StoryTable& table) {
  std::string html = "<div class=\"table\">\n";
  html += table.has_numbers ? "<table>\n" : "<table class=\"words\">\n";
  html += table_row(table.head, "th", false);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    html += table_row(table.rows[row], "td", row == table.marked_row);
  }
  return html + "</table>\n</div>\n";
}

std::string html_figure(const Figure& figure) {
  std::string html = "<div class=\"figure\">\n";
  for (const SvgCanvas& panel : figure) {
    const double width_px = panel.width_px();
    html += panel.element(width_px > 900.0 ? "wide" : width_px > 500.0 ? "half" : "");
  }
  return html + "</div>\n";
}

std::string head(const MatchStory& story) {
  const std::string_view status = to_string(story.result.status);
  std::string html = element("h1", "How two scans were matched");
  html += fmt::format("<p class=\"remark\">{}</p>\n", escape_xml(match_subtitle(story)));
  html += fmt::format("<p><span class=\"status {0}\">{0}</span></p>\n", status);
  html += "<ul class=\"evidence\">\n";
  for (const std::string& sentence : story.evidence) html += element("li", sentence);
  return html + "</ul>\n";
}

}  // namespace

std::string match_report_html(const MatchStory& story) {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n";
  page += element("title", fmt::format("Match: {}", match_subtitle(story)));
  page += fmt::format("<style>{}</style>\n</head>\n<body>\n", kStyle);
  page += head(story);
  for (const MatchSection& section : match_sections(story)) {
    page += element("h2", section.title);
    page += fmt::format("<p class=\"remark\">{}</p>\n", escape_xml(section.caption));
    page += section.table ? html_table(*section.table) : html_figure(section.figure);
  }
  return page + "</body>\n</html>\n";
}

}  // namespace setsquare
