// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <string_view>
#include <vector>

#include "setsquare/drawing/text.hpp"
#include "setsquare/report/match/figures/proposal_table.hpp"
#include "setsquare/report/match/report.hpp"
#include "setsquare/report/match/sections.hpp"

namespace setsquare {
namespace {

constexpr std::string_view kStyle = R"css(
body { font: 15px/1.5 Helvetica, Arial, "Liberation Sans", sans-serif; color: #1f2933;
       max-width: 1320px; margin: 32px auto; padding: 0 24px; }
h1 { font-size: 26px; margin: 0; }
h2 { font-size: 18px; margin: 40px 0 2px; }
p.remark { color: #64707d; margin: 2px 0 12px; }
.status { display: inline-block; padding: 3px 14px; border-radius: 14px; color: #ffffff;
          font-weight: bold; }
.matched { background: #12805c; }
.ambiguous, .degenerate { background: #b26a00; }
.no_overlap, .too_few_points, .rejected { background: #d02a3c; }
ul.evidence { padding-left: 20px; }
svg { max-width: 100%; height: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: 14px; }
th, td { padding: 4px 14px 4px 0; border-bottom: 1px solid #e3e7eb; text-align: right; }
th:last-child, td:last-child { text-align: left; padding-left: 18px; }
tr.answer td { color: #12805c; font-weight: bold; }
)css";

std::string element(std::string_view tag, std::string_view words) {
  return joined({"<", tag, ">", escape_xml(words), "</", tag, ">\n"});
}

std::string table_row(const std::vector<std::string>& cells, std::string_view tag, bool is_answer) {
  std::string row = is_answer ? "<tr class=\"answer\">" : "<tr>";
  for (const std::string& cell : cells) row += element(tag, cell);
  return row + "</tr>\n";
}

std::string proposal_table(const MatchStory& story) {
  std::string table = "<table>\n" + table_row(proposal_table_head(story), "th", false);
  for (std::size_t i = 0; i < story.proposals.size(); ++i) {
    table += table_row(proposal_table_row(story, i), "td", i == 0);
  }
  return table + "</table>\n";
}

std::string head(const MatchStory& story) {
  const std::string status(to_string(story.result.status));
  std::string text = element("h1", "How two scans were matched");
  text += joined({"<p class=\"remark\">", escape_xml(match_subtitle(story)), "</p>\n"});
  text += joined({"<p><span class=\"status ", status, "\">", status, "</span></p>\n"});
  text += "<ul class=\"evidence\">\n";
  for (const std::string& sentence : story.evidence) text += element("li", sentence);
  return text + "</ul>\n";
}

}  // namespace

std::string match_report_html(const MatchStory& story) {
  std::string page =
      joined({"<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n",
              element("title", joined({"Match: ", match_subtitle(story)})),
              "<style>",
              kStyle,
              "</style>\n</head>\n<body>\n",
              head(story)});
  for (const MatchSection& section : match_sections(story)) {
    page += element("h2", section.title);
    page += joined({"<p class=\"remark\">", escape_xml(section.caption), "</p>\n"});
    page += section.is_table ? proposal_table(story) : section.figure.element();
  }
  return page + "</body>\n</html>\n";
}

}  // namespace setsquare
