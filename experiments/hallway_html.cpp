// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <functional>

#include "experiments/hallway_report.hpp"
#include "experiments/page_elements.hpp"
#include "experiments/plan_figure.hpp"
#include "setsquare/drawing/text.hpp"

namespace setsquare::experiments {
namespace {

using CellOfPair = std::function<Cell(const HallwayPair&)>;

/// A triangle of cells: references down, current scans across, as in the paper's tables.
std::string matrix_html(const HallwayRun& run, const std::string& title, const CellOfPair& cell) {
  const std::size_t n = run.T_map_base.size();
  std::string html = joined({"<div><h3>", title, "</h3>\n<table class=\"matrix\"><tr><th></th>"});
  for (std::size_t j = 1; j < n; ++j) html += element("th", number(j));
  html += "</tr>\n";
  std::size_t pair = 0;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    html += joined({"<tr>", element("th", number(i))});
    for (std::size_t j = 1; j < n; ++j) {
      if (j <= i) {
        html += "<td></td>";
        continue;
      }
      const Cell shown = cell(run.pairs[pair++]);
      html += joined({"<td class=\"", shown.style, "\">", escape_xml(shown.words), "</td>"});
    }
    html += "</tr>\n";
  }
  return html + "</table></div>\n";
}

Cell success_cell(const PairAnswer& answer) {
  return answer.is_success() ? Cell{"S", ""} : Cell{"F", "bad"};
}

std::string matrices(const HallwayStudy& study) {
  const HallwayRun& run = study.runs.front();
  std::string html = "<div class=\"charts\">\n";
  html += matrix_html(run, "Table 1: overlap in %", [](const HallwayPair& pair) {
    const double overlap = pair.record.truth.overlap;
    return Cell{number(100.0 * overlap, 0), overlap > 0.4 ? "high" : "faint"};
  });
  if (study.has_icp) {
    html += matrix_html(
        run, "Table 2: ICP", [](const HallwayPair& pair) { return success_cell(pair.icp); });
  } else {
    html += "<div><h3>Table 2: ICP</h3><p>MRPT is not installed.</p></div>\n";
  }
  html += matrix_html(run, "Table 3: the paper's method", [](const HallwayPair& pair) {
    return success_cell(pair.record.paper);
  });
  html += matrix_html(run, "The default matcher", [](const HallwayPair& pair) {
    return success_cell(pair.record.ours);
  });
  return html + "</div>\n";
}

std::string spread_text(const Spread& spread, double unit, int num_decimals) {
  return joined({number(unit * spread.mean(), num_decimals),
                 " (",
                 number(unit * spread.sigma(), num_decimals),
                 ")"});
}

std::vector<Cell> aggregate_row(const std::string& name,
                                const Tally& all,
                                const Tally& high,
                                const std::string& time) {
  return {{name},
          {joined({number(all.num_success), " of ", number(all.num_pairs)})},
          {joined({number(high.num_success), " of ", number(high.num_pairs)})},
          {percent(high.success_share(), 1)},
          {spread_text(all.success_error_m, 1.0, 4)},
          {spread_text(all.success_error_rad, deg_from_rad(1.0), 3)},
          {time}};
}

std::vector<Cell> absent_row(const std::string& name) {
  return {{name}, {"MRPT is not installed", "faint"}, {"-"}, {"-"}, {"-"}, {"-"}, {"-"}};
}

Table aggregates(const HallwayStudy& study, std::size_t num_runs, const std::string& title) {
  const HallwaySummary summary = summarise(study, num_runs);
  const bool is_first = num_runs == 1;
  const auto time = [is_first](double time_ms) {
    return is_first ? number(time_ms, 2) + " ms" : std::string("-");
  };
  Table table{title,
              {"method",
               "right, all pairs",
               "right, overlap >= 45 %",
               "share",
               "error [m] (sigma)",
               "error [deg] (sigma)",
               "a match"},
              {}};
  table.rows.push_back({{"paper: ICP, as stated", "faint"},
                        {"-"},
                        {"-"},
                        {"-"},
                        {"0.07 (0.03)"},
                        {"0.51 (0.32)"},
                        {"11 ms, 2014"}});
  table.rows.push_back({{"paper: proposed method, as stated", "faint"},
                        {"-"},
                        {"all"},
                        {"100 %"},
                        {"0.04 (0.02)"},
                        {"0.33 (0.25)"},
                        {"17 ms, 2014"}});
  table.rows.push_back(
      study.has_icp
          ? aggregate_row(
                "here: MRPT's ICP", summary.icp, summary.icp_high, time(study.times.icp_ms))
          : absent_row("here: MRPT's ICP"));
  table.rows.push_back(aggregate_row("here: the paper's method (--preset paper)",
                                     summary.paper,
                                     summary.paper_high,
                                     time(study.times.paper_ms)));
  table.rows.push_back(aggregate_row(
      "here: the default matcher", summary.ours, summary.ours_high, time(study.times.ours_ms)));
  return table;
}

}  // namespace

std::string hallway_html(const HallwayStudy& study) {
  const HallwayRun& first = study.runs.front();
  std::string html = paragraph(
      joined({number(first.T_map_base.size()),
              " scans of a UTM-30LX, 0.4 m or 10 deg apart, along a hallway; all ",
              number(first.pairs.size()),
              " pairs, without an initial guess. Right is a pose within 0.2 m and 30 deg of the "
              "truth. ICP is MRPT's, Levenberg-Marquardt, default parameters, started at zero. "
              "Overlap is the share of the current scan's returns that, at the true pose, lie "
              "within 0.2 m of a surface that the reference saw. The text of the paper gives "
              "aggregates, not the cells of its tables."}));
  html += command_line("setsquare experiment paper --only section_5_1 -o out");
  html += figure(plan_svg(first.plan, {{"the robot's path", first.T_map_base}}, true),
                 "Figure 4: the hallway of seed 1 and the places of its scans, 0 to 14.");
  html += matrices(study);
  html += table_html(aggregates(study, 1, "The first hallway"));
  html += table_html(
      aggregates(study,
                 study.runs.size(),
                 joined({"The same over ", number(study.runs.size()), " seeds of hallways"})));
  return html;
}

std::string hallway_text(const HallwayStudy& study) {
  return table_text(
      aggregates(study,
                 study.runs.size(),
                 joined({"Section 5.1, ", number(study.runs.size()), " seeds of hallways"})));
}

}  // namespace setsquare::experiments
