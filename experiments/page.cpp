// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "experiments/page_elements.hpp"
#include "setsquare/drawing/text.hpp"

namespace setsquare::experiments {
namespace {

constexpr std::string_view kStyle = R"css(
:root { color-scheme: light dark; --ink: #1f2933; --faint: #5b6772; --paper: #ffffff;
        --line: #dfe4e8; --box: #f4f6f8; --good: #12805c; --bad: #c02335;
        --s1: #1f5fa8; --s2: #d0601c; --s3: #12805c; --s4: #a02a72; --s5: #6b6f00; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e8ec; --faint: #9aa6b1; --paper: #14181c; --line: #333b43; --box: #1d2329;
          --good: #4cc79a; --bad: #ff7b86;
          --s1: #6ba7ec; --s2: #f39a5c; --s3: #4cc79a; --s4: #e27bb8; --s5: #c9cd52; } }
body { font: 16px/1.55 system-ui, Helvetica, Arial, "Liberation Sans", sans-serif;
       color: var(--ink); background: var(--paper); max-width: 1080px; margin: 40px auto;
       padding: 0 24px; }
h1 { font-size: 30px; line-height: 1.2; margin: 0 0 12px; }
h2 { font-size: 22px; margin: 56px 0 8px; border-top: 1px solid var(--line); padding-top: 24px; }
h3 { font-size: 17px; margin: 32px 0 4px; }
p { max-width: 46em; }
nav ul { padding-left: 20px; }
a { color: var(--s1); }
pre { background: var(--box); padding: 8px 14px; border-radius: 6px; overflow-x: auto;
      font-size: 14px; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: 14px;
        margin: 12px 0 20px; }
caption { text-align: left; color: var(--faint); padding-bottom: 6px; }
th, td { padding: 4px 16px 4px 0; border-bottom: 1px solid var(--line); text-align: right;
         vertical-align: top; }
th { font-weight: 600; }
tr > :first-child { text-align: left; }
tbody th { font-weight: normal; }
.good { color: var(--good); font-weight: 600; }
.bad { color: var(--bad); font-weight: 600; }
.faint { color: var(--faint); }
table.matrix { font-size: 12px; }
table.matrix th, table.matrix td { padding: 2px 7px; text-align: center; border: none; }
table.matrix td.high { background: var(--box); font-weight: 600; }
figure { margin: 20px 0; }
figcaption { color: var(--faint); font-size: 14px; max-width: 50em; }
svg, img { max-width: 100%; height: auto; }
svg text { fill: var(--ink); font: 12px system-ui, Helvetica, Arial, sans-serif; }
svg text.faint { fill: var(--faint); }
svg .guide { stroke: var(--line); fill: none; }
svg .wall { stroke: var(--faint); fill: none; stroke-width: 1; }
svg .s1 { stroke: var(--s1); } svg .s2 { stroke: var(--s2); } svg .s3 { stroke: var(--s3); }
svg .s4 { stroke: var(--s4); } svg .s5 { stroke: var(--s5); }
svg .curve { fill: none; stroke-width: 2; }
svg circle.s1 { fill: var(--s1); } svg circle.s2 { fill: var(--s2); }
svg circle.s3 { fill: var(--s3); } svg circle.s4 { fill: var(--s4); }
svg circle.s5 { fill: var(--s5); }
.charts { display: flex; flex-wrap: wrap; gap: 12px; }
details { margin: 8px 0; } summary { cursor: pointer; color: var(--s1); }
)css";

std::string contents_html(const std::vector<PageSection>& sections) {
  std::string html = "<nav><ul>\n";
  for (const PageSection& section : sections) {
    html += joined(
        {"<li><a href=\"#", section.anchor, "\">", escape_xml(section.title), "</a></li>\n"});
  }
  return html + "</ul></nav>\n";
}

}  // namespace

std::string page_html(std::string_view title,
                      std::string_view introduction,
                      const std::vector<PageSection>& sections) {
  std::string page =
      joined({"<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
              "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n",
              element("title", title),
              "<style>",
              kStyle,
              "</style>\n</head>\n<body>\n",
              element("h1", title),
              introduction,
              contents_html(sections)});
  for (const PageSection& section : sections) {
    page += joined({"<section id=\"", section.anchor, "\">\n", element("h2", section.title)});
    page += section.content;
    page += "</section>\n";
  }
  return page + "</body>\n</html>\n";
}

}  // namespace setsquare::experiments
