// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/page.hpp"

#include <array>

#include "setsquare/drawing/text.hpp"
#include "setsquare/report/map/page_data.hpp"
#include "setsquare/report/map/page_web.hpp"
#include "setsquare/report/page_template.hpp"

namespace setsquare {

std::string map_report_html(const MapReport& report) {
  const std::array<PageMark, 5> marks = {{{"@TITLE@", escape_xml(report.title)},
                                          {"@STYLE@", map_report_style()},
                                          {"@HEADLINE@", escape_xml(report.title)},
                                          {"@DATA@", map_report_json(report)},
                                          {"@SCRIPT@", map_report_script()}}};
  return filled_page(map_report_page(), marks);
}

}  // namespace setsquare
