// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/factor_report.hpp"

#include <algorithm>
#include <limits>

#include "experiments/chart.hpp"
#include "experiments/page_elements.hpp"
#include "setsquare/drawing/text.hpp"

namespace setsquare::experiments {
namespace {

Json json_from(const MatcherSummary& summary) {
  Json by_overlap = Json::array();
  for (const Tally& bin : summary.by_overlap) by_overlap.push_back(bin.success_share());
  return {{"all_pairs", experiments::json_from(summary.all)},
          {"determined", experiments::json_from(summary.determined)},
          {"determined_overlap_45_and_more", experiments::json_from(summary.high)},
          {"determined_overlap_30_to_45", experiments::json_from(summary.middle)},
          {"determined_success_by_tenth_of_overlap", by_overlap}};
}

std::vector<Cell> level_row(const FactorOutcome& outcome) {
  const MatcherSummary& ours = outcome.summary.ours;
  const MatcherSummary& paper = outcome.summary.paper;
  return {{outcome.level},
          {number(outcome.summary.num_pairs)},
          {percent(ours.high.success_share())},
          {percent(ours.middle.success_share())},
          {percent(ours.all.matched_share(), 1)},
          {number(ours.all.num_wrong), ours.all.num_wrong == 0 ? "" : "bad"},
          {percent(ours.all.wrong_share(), 3)},
          {number(ours.determined.success_error_m.mean(), 4)},
          {number(deg_from_rad(ours.determined.success_error_rad.mean()), 3)},
          {number(ours.all.right_nees.mean(), 2)},
          {percent(ours.all.right_nees_inside_share(), 1)},
          {percent(paper.high.success_share())},
          {percent(paper.all.wrong_share(), 1)}};
}

Table factor_table(const std::vector<FactorOutcome>& outcomes) {
  Table table{"",
              {outcomes.front().factor,
               "pairs",
               "right at >= 45 %",
               "right at 30-45 %",
               "matched",
               "wrong",
               "of matched",
               "error [m]",
               "error [deg]",
               "mean NEES (right)",
               "NEES < 7.81 (right)",
               "paper: right at >= 45 %",
               "paper: wrong of matched"},
              {}};
  for (const FactorOutcome& outcome : outcomes) table.rows.push_back(level_row(outcome));
  return table;
}

/// The outcomes of one factor after the other.
std::vector<std::vector<FactorOutcome>> by_factor(const FactorStudy& study) {
  std::vector<std::vector<FactorOutcome>> factors;
  for (const FactorOutcome& outcome : study.outcomes) {
    if (factors.empty() || factors.back().front().factor != outcome.factor) factors.emplace_back();
    factors.back().push_back(outcome);
  }
  return factors;
}

/// Success against overlap, a curve a level.
std::string overlap_chart(const std::vector<FactorOutcome>& outcomes) {
  Chart chart{
      "Default matcher: right, of determined pairs", "overlap [%]", "[%]", 0, 100, 0, 100, {}, {}};
  for (const FactorOutcome& outcome : outcomes) {
    Series series{outcome.level, {}};
    for (std::size_t i = 0; i < outcome.summary.ours.by_overlap.size(); ++i) {
      const Tally& bin = outcome.summary.ours.by_overlap[i];
      series.points.emplace_back(10.0 * static_cast<double>(i) + 5.0,
                                 bin.num_pairs >= 10 ? 100.0 * bin.success_share()
                                                     : std::numeric_limits<double>::quiet_NaN());
    }
    chart.series.push_back(series);
  }
  return chart_svg(chart);
}

/// Success and wrong answers against the level.
std::string level_charts(const std::vector<FactorOutcome>& outcomes) {
  std::vector<std::string> levels;
  std::vector<Series> right = {{"default", {}}, {"default, matched", {}}, {"paper", {}}};
  std::vector<Series> wrong = {{"default", {}}, {"paper", {}}};
  std::vector<Series> error = {{"default", {}}, {"paper", {}}};
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const MatcherSummary& ours = outcomes[i].summary.ours;
    const MatcherSummary& paper = outcomes[i].summary.paper;
    const auto x = static_cast<double>(i);
    levels.push_back(outcomes[i].level);
    right[0].points.emplace_back(x, 100.0 * ours.high.success_share());
    right[1].points.emplace_back(x, 100.0 * ours.high.matched_share());
    right[2].points.emplace_back(x, 100.0 * paper.high.success_share());
    wrong[0].points.emplace_back(x, 100.0 * ours.all.wrong_share());
    wrong[1].points.emplace_back(x, 100.0 * paper.all.wrong_share());
    error[0].points.emplace_back(x, 1000.0 * ours.determined.success_error_m.mean());
    error[1].points.emplace_back(x, 1000.0 * paper.determined.success_error_m.mean());
  }
  const double low = -0.3;
  const double high = static_cast<double>(outcomes.size()) - 0.7;
  const std::string& factor = outcomes.front().factor;
  return chart_svg({"Right at >= 45 % overlap", factor, "[%]", low, high, 0, 100, levels, right}) +
         chart_svg({"Wrong among matched",
                    factor,
                    "[%]",
                    low,
                    high,
                    0,
                    highest_y(wrong, 1.0),
                    levels,
                    wrong}) +
         chart_svg({"Mean error of the right poses",
                    factor,
                    "[mm]",
                    low,
                    high,
                    0,
                    highest_y(error, 10.0),
                    levels,
                    error});
}

}  // namespace

Json json_from(const FactorStudy& study) {
  Json levels = Json::array();
  for (const FactorOutcome& outcome : study.outcomes) {
    levels.push_back({{"factor", outcome.factor},
                      {"level", outcome.level},
                      {"num_pairs", outcome.summary.num_pairs},
                      {"num_overlap_45_and_more", outcome.summary.num_high},
                      {"num_of_those_undetermined", outcome.summary.num_high_undetermined},
                      {"default", json_from(outcome.summary.ours)},
                      {"paper", json_from(outcome.summary.paper)}});
  }
  return {{"num_seeds_of_each_class", study.num_seeds}, {"levels", levels}};
}

std::string factor_html(const FactorStudy& study) {
  std::string html = paragraph(joined(
      {"The buildings of the first ",
       number(study.num_seeds),
       " seeds of each class again, a fifth of their pairs, with one thing changed at a time: the "
       "people, the field of view, the number of beams over 270 deg, the scanner, the robot's "
       "speed (it "
       "smears a sweep). Pairs and limits are those of the section before; under fewer "
       "beams a pair keeps the overlap that all 1081 beams give it."}));
  html += command_line("setsquare experiment paper --only factors -o out");
  for (const std::vector<FactorOutcome>& outcomes : by_factor(study)) {
    html += element("h3", outcomes.front().factor);
    html += table_html(factor_table(outcomes));
    const std::string charts =
        outcomes.size() > 5 ? level_charts(outcomes) : overlap_chart(outcomes);
    html += joined({"<div class=\"charts\">\n", charts, "</div>\n"});
  }
  return html;
}

std::string factor_text(const FactorStudy& study) {
  std::string text;
  for (const std::vector<FactorOutcome>& outcomes : by_factor(study)) {
    text += table_text(factor_table(outcomes));
  }
  return text;
}

}  // namespace setsquare::experiments
