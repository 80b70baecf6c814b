// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "experiments/building_report.hpp"
#include "experiments/building_summary.hpp"
#include "experiments/chart.hpp"
#include "experiments/page_elements.hpp"
#include "setsquare/drawing/text.hpp"

namespace setsquare::experiments {
namespace {

std::vector<Cell> class_row(const BuildingSummary& summary, const MatcherSummary& matcher) {
  const double to_deg = deg_from_rad(1.0);
  return {{summary.name},
          {number(matcher.all.num_pairs)},
          {number(matcher.high.num_pairs)},
          {percent(matcher.high.success_share())},
          {percent(matcher.middle.success_share())},
          {percent(matcher.all.matched_share(), 1)},
          {number(matcher.all.num_wrong), matcher.all.num_wrong == 0 ? "" : "bad"},
          {percent(matcher.all.wrong_share(), 3)},
          {number(matcher.determined.success_error_m.mean(), 4)},
          {number(to_deg * matcher.determined.success_error_rad.mean(), 3)},
          {number(matcher.all.right_nees.mean(), 2)},
          {percent(matcher.all.right_nees_inside_share(), 1)},
          {percent(matcher.all.nees_inside_share(), 1)}};
}

Table class_table(const std::vector<BuildingSummary>& summaries,
                  MatcherSummary BuildingSummary::*matcher,
                  const std::string& caption) {
  Table table{caption,
              {"class",
               "pairs",
               "determined, overlap >= 45 %",
               "of those right",
               "right at 30-45 %",
               "matched (all pairs)",
               "wrong",
               "of matched",
               "error [m]",
               "error [deg]",
               "mean NEES (right matched)",
               "NEES < 7.81 (right matched)",
               "NEES < 7.81 (all matched)"},
              {}};
  for (const BuildingSummary& summary : summaries) {
    table.rows.push_back(class_row(summary, summary.*matcher));
  }
  return table;
}

using BinValue = double (*)(const Tally&);

Series bin_series(const std::string& name, const std::array<Tally, 10>& bins, BinValue value) {
  Series series{name, {}};
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const double middle = 10.0 * static_cast<double>(i) + 5.0;
    const bool has_enough = bins[i].num_pairs >= 10;
    series.points.emplace_back(
        middle, has_enough ? value(bins[i]) : std::numeric_limits<double>::quiet_NaN());
  }
  return series;
}

std::string overlap_charts(const BuildingSummary& all) {
  const auto success = [](const Tally& tally) { return 100.0 * tally.success_share(); };
  const auto matched = [](const Tally& tally) { return 100.0 * tally.matched_share(); };
  const auto wrong = [](const Tally& tally) {
    return tally.num_matched >= 10 ? 100.0 * tally.wrong_share()
                                   : std::numeric_limits<double>::quiet_NaN();
  };
  const auto error = [](const Tally& tally) { return 1000.0 * tally.success_error_m.mean(); };
  const std::vector<Series> right = {
      bin_series("default, pose right", all.ours.by_overlap, success),
      bin_series("default, matched", all.ours.by_overlap, matched),
      bin_series("paper, pose right", all.paper.by_overlap, success)};
  const std::vector<Series> wrongs = {bin_series("default", all.ours.all_by_overlap, wrong),
                                      bin_series("paper", all.paper.all_by_overlap, wrong)};
  const std::vector<Series> errors = {bin_series("default", all.ours.by_overlap, error),
                                      bin_series("paper", all.paper.by_overlap, error)};
  std::string html = "<div class=\"charts\">\n";
  html += chart_svg({"Determined pairs", "overlap [%]", "[%]", 0, 100, 0, 100, {}, right});
  html += chart_svg({"Wrong among matched, all pairs",
                     "overlap [%]",
                     "[%]",
                     0,
                     100,
                     0,
                     highest_y(wrongs, 1.0),
                     {},
                     wrongs});
  html += chart_svg({"Mean error of the right poses",
                     "overlap [%]",
                     "[mm]",
                     0,
                     100,
                     0,
                     highest_y(errors, 10.0),
                     {},
                     errors});
  return html + "</div>\n";
}

Table pair_table(const std::vector<ListedPair>& pairs, std::size_t max_rows) {
  Table table{
      "", {"class", "seed", "reference", "current", "overlap", "status", "error [m]", "[deg]"}, {}};
  for (std::size_t i = 0; i < std::min(pairs.size(), max_rows); ++i) {
    const PairTruth& truth = pairs[i].record->truth;
    const PairAnswer& answer = pairs[i].record->ours;
    table.rows.push_back({{std::string(to_string(pairs[i].building->building_class))},
                          {number(pairs[i].building->seed)},
                          {number(truth.reference)},
                          {number(truth.current)},
                          {percent(truth.overlap, 1)},
                          {std::string(to_string(answer.status))},
                          {number(answer.error_m(), 3)},
                          {number(deg_from_rad(answer.error_rad()), 2)}});
  }
  return table;
}

std::string listing(const std::string& title, const std::vector<ListedPair>& pairs) {
  constexpr std::size_t kMaxRows = 500;
  std::string words = joined({title, ": ", number(pairs.size())});
  if (pairs.size() > kMaxRows) words += " (the first 500 here, all in paper.json)";
  return folding(words, table_html(pair_table(pairs, kMaxRows)));
}

}  // namespace

std::string building_html(const BuildingStudy& study) {
  const std::vector<BuildingSummary> summaries = summarise_by_class(study);
  const BuildingSummary& all = summaries.back();
  const PairLists lists = list_pairs(study);
  std::string html =
      paragraph(joined({number(all.num_buildings),
                        " buildings of five classes, seeds 1 to ",
                        number(all.num_buildings / (summaries.size() - 1)),
                        " of each; in each one run of about 16 scans of a UTM-30LX, and every pair "
                        "of them within 5 m: ",
                        number(all.num_pairs),
                        " pairs, ",
                        percent(share(all.num_below_60, all.num_pairs), 1),
                        " of them below 60 % overlap; ",
                        percent(all.clutter_share.mean(), 1),
                        " of the returns come from furniture, clutter and people. A pose is right "
                        "within 0.2 m and 30 deg of the truth (the paper's limits); an answer "
                        "'matched' is wrong when it is off by more than 0.2 m or 3 deg."}));
  html += paragraph(
      joined({"Success is told of the pairs that the floor plan determines. Of the ",
              number(all.num_high),
              " pairs of at least 45 % overlap ",
              number(all.num_high_undetermined),
              " (",
              percent(share(all.num_high_undetermined, all.num_high)),
              ") are not: bare corridors and round walls, where no matcher can know. They are "
              "listed below; wrong answers are counted over all pairs, these included."}));
  html += command_line("setsquare experiment paper --only buildings -o out");
  html += table_html(class_table(summaries, &BuildingSummary::ours, "The default matcher"));
  html += table_html(
      class_table(summaries,
                  &BuildingSummary::paper,
                  "The paper's method ('matched' above its threshold; it gives no covariance)"));
  html += figure(overlap_charts(all),
                 "Against overlap, all classes; bins of at least 10 pairs (of 10 matched, where it "
                 "is about those).");
  html += listing("Wrong answers of the default matcher", lists.wrong);
  html += listing("Determined pairs of at least 45 % overlap that it misses", lists.failures);
  html +=
      listing("Pairs of at least 45 % overlap that the plan does not determine", lists.excluded);
  return html;
}

}  // namespace setsquare::experiments
