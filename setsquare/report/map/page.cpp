// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/page.hpp"

#include <array>
#include <cassert>
#include <string_view>
#include <utility>

#include "setsquare/drawing/text.hpp"
#include "setsquare/report/map/page_data.hpp"
#include "setsquare/report/map/page_web.hpp"

namespace setsquare {

std::string map_report_html(const MapReport& report) {
  // In the order of the page, so that nothing that was put in is taken for a mark.
  const std::array<std::pair<std::string_view, std::string>, 5> pieces = {
      {{"@TITLE@", escape_xml(report.title)},
       {"@STYLE@", map_report_style()},
       {"@HEADLINE@", escape_xml(report.title)},
       {"@DATA@", map_report_json(report)},
       {"@SCRIPT@", map_report_script()}}};
  const std::string page = map_report_page();
  std::string html;
  std::size_t done = 0;
  for (const auto& [mark, text] : pieces) {
    const std::size_t place = page.find(mark, done);
    assert(place != std::string::npos);
    html.append(page, done, place - done);
    html += text;
    done = place + mark.size();
  }
  html.append(page, done);
  return html;
}

}  // namespace setsquare
