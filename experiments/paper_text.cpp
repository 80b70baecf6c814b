// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The tables of `setsquare experiment paper` for a terminal.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "experiments/paper_experiment.hpp"
#include "experiments/text_table.hpp"

namespace setsquare::experiments {
namespace {

std::string degrees(const Spread& spread_rad, int num_decimals) {
  return number(deg_from_rad(spread_rad.mean()), num_decimals);
}

// Section 5.1.

std::vector<std::string> hallway_row(const std::string& name, const Tally& all, const Tally& high) {
  const Spread& error_m = all.success_error_m;
  const Spread& error_rad = all.success_error_rad;
  return {
      name,
      fmt::format("{} of {}", all.num_success, all.num_pairs),
      fmt::format("{} of {}", high.num_success, high.num_pairs),
      percent(high.success_share(), 1),
      fmt::format("{} ({})", number(error_m.mean(), 4), number(error_m.sigma(), 4)),
      fmt::format("{} ({})", degrees(error_rad, 3), number(deg_from_rad(error_rad.sigma()), 3))};
}

std::string hallway_text(const HallwayStudy& study) {
  const HallwaySummary summary = summarise(study, study.runs.size());
  TextTable table{
      fmt::format("Section 5.1, {} seeds of hallways", study.runs.size()),
      {"method",
       "right, all pairs",
       "right, overlap >= 45 %",
       "share",
       "error [m] (sigma)",
       "error [deg] (sigma)"},
      {{"the paper states: ICP", "-", "-", "-", "0.07 (0.03)", "0.51 (0.32)"},
       {"the paper states: its method", "-", "all", "100 %", "0.04 (0.02)", "0.33 (0.25)"}}};
  if (study.has_icp) {
    table.rows.push_back(hallway_row("here: MRPT's ICP", summary.icp, summary.icp_high));
  } else {
    table.rows.push_back({"here: MRPT's ICP", "not built", "-", "-", "-", "-"});
  }
  table.rows.push_back(
      hallway_row("here: the paper's method (--preset paper)", summary.paper, summary.paper_high));
  table.rows.push_back(hallway_row("here: the default matcher", summary.ours, summary.ours_high));
  return text_of(table);
}

// Pairs in many buildings.

std::vector<std::string> class_row(const std::string& name, const MatcherSummary& matcher) {
  return {name,
          fmt::format("{}", matcher.all.num_pairs),
          fmt::format("{}", matcher.high.num_pairs),
          percent(matcher.high.success_share()),
          percent(matcher.middle.success_share()),
          percent(matcher.all.matched_share(), 1),
          fmt::format("{}", matcher.all.num_wrong),
          percent(matcher.all.wrong_share(), 3),
          number(matcher.determined.success_error_m.mean(), 4),
          degrees(matcher.determined.success_error_rad, 3),
          number(matcher.all.right_nees.mean(), 2),
          percent(matcher.all.right_nees_inside_share(), 1)};
}

/// The first pairs of a list, one per line.
std::string listing_text(const char* title, const std::vector<ListedPair>& pairs) {
  constexpr std::size_t kMaxLines = 20;
  std::string text = fmt::format(
      "{}: {}{}\n", title, pairs.size(), pairs.size() > kMaxLines ? ", the first 20:" : "");
  for (std::size_t i = 0; i < std::min(pairs.size(), kMaxLines); ++i) {
    const PairTruth& truth = pairs[i].record->truth;
    const PairAnswer& answer = pairs[i].record->ours;
    text += fmt::format(
        "  {:<9} seed {:>2}, {:>2}-{:>2}: overlap {:>5.1f} %, {}, off by {:.3f} m, {:.2f} deg\n",
        to_string(pairs[i].building->building_class),
        pairs[i].building->seed,
        truth.reference,
        truth.current,
        100.0 * truth.overlap,
        to_string(answer.status),
        answer.error_m(),
        deg_from_rad(answer.error_rad()));
  }
  return text;
}

/// The heads of a table of pairs; the first column is what it goes by.
std::vector<std::string> pair_heads(const std::string& first) {
  return {first,
          "pairs",
          ">= 45 %",
          "right",
          "right at 30-45 %",
          "matched",
          "wrong",
          "of matched",
          "error [m]",
          "[deg]",
          "NEES",
          "< 7.81"};
}

std::string building_text(const BuildingStudy& study) {
  const std::vector<BuildingSummary> summaries = summarise_by_class(study);
  const BuildingSummary& all = summaries.back();
  TextTable table{
      "Pairs in many buildings; right: of the pairs that the plan determines; NEES: of "
      "the right matched",
      pair_heads("class"),
      {}};
  for (const BuildingSummary& summary : summaries) {
    table.rows.push_back(class_row(summary.name + ", default", summary.ours));
  }
  for (const BuildingSummary& summary : summaries) {
    table.rows.push_back(class_row(summary.name + ", paper", summary.paper));
  }
  const PairLists lists = list_pairs(study);
  return text_of(table) +
         fmt::format(
             "{} buildings; {} of the pairs below 60 % overlap; clutter {} of the returns; {} "
             "pairs ({}) of >= 45 % excluded as undetermined\n",
             all.num_buildings,
             percent(share(all.num_below_60, all.num_pairs), 1),
             percent(all.clutter_share.mean(), 1),
             all.num_high_undetermined,
             percent(share(all.num_high_undetermined, all.num_high))) +
         listing_text("wrong", lists.wrong) + listing_text("missed at >= 45 %", lists.failures);
}

// One factor at a time.

std::vector<std::string> level_row(const FactorOutcome& outcome) {
  std::vector<std::string> row = class_row(outcome.level, outcome.summary.ours);
  const MatcherSummary& paper = outcome.summary.paper;
  row.push_back(percent(paper.high.success_share()));
  row.push_back(percent(paper.all.wrong_share(), 1));
  return row;
}

std::string factor_text(const FactorStudy& study) {
  std::string text;
  for (auto first = study.outcomes.begin(); first != study.outcomes.end();) {
    const auto next = std::find_if(first, study.outcomes.end(), [&](const FactorOutcome& outcome) {
      return outcome.factor != first->factor;
    });
    std::vector<std::string> heads = pair_heads(first->factor);
    heads.insert(heads.end(), {"paper: right", "paper: wrong of matched"});
    TextTable table{"", std::move(heads), {}};
    for (; first != next; ++first) table.rows.push_back(level_row(*first));
    text += text_of(table);
  }
  return text;
}

// Section 5.2.

std::string closure_cell(const ClosureMedians& medians, std::size_t circuit) {
  return fmt::format("{:.3f}, {:.3f}; {:.3f}",
                     medians.x_m[circuit],
                     medians.y_m[circuit],
                     medians.norm_m[circuit]);
}

std::string closure_text(const CircuitStudy& study) {
  const ClosureMedians literal = closure_medians(study, &CircuitRun::paper_literal);
  const ClosureMedians paper = closure_medians(study, &CircuitRun::paper);
  const ClosureMedians ours = closure_medians(study, &CircuitRun::ours);
  const ClosureMedians mapper = closure_medians(study, &CircuitRun::mapper);
  TextTable table{
      fmt::format("Section 5.2: closure errors |x|, |y|; norm in m, median of {} seeds; "
                  "only the full mapper closes loops",
                  study.runs.size()),
      {"circuit",
       "length [m]",
       "the paper states",
       "paper, literal",
       "paper, in sequence",
       "default, scan to scan",
       "full mapper"},
      {}};
  const char* stated[] = {"0.3, 0.8; 0.85", "0.5, 1.2; 1.30"};
  for (std::size_t c = 0; c < 2; ++c) {
    const CircuitScans& circuit = study.runs.front().circuits[c];
    table.rows.push_back({circuit.order,
                          number(circuit.length_m, 1),
                          stated[c],
                          closure_cell(literal, c),
                          closure_cell(paper, c),
                          closure_cell(ours, c),
                          closure_cell(mapper, c)});
  }
  return text_of(table);
}

/// Median and worst.
std::string spread_cell(const std::vector<double>& values, int num_decimals) {
  return fmt::format("{}, {}",
                     number(median(values), num_decimals),
                     number(*std::max_element(values.begin(), values.end()), num_decimals));
}

std::vector<std::string> mapper_row(const std::string& name,
                                    const CircuitStudy& study,
                                    MapErrors CircuitRun::*errors) {
  std::vector<double> final_m, mean_m, best_mean_m, heading_deg;
  std::size_t num_unjoined = 0;
  ClosureCounts closures;
  for (const CircuitRun& run : study.runs) {
    const MapErrors& map = run.*errors;
    final_m.push_back(map.first_final_m);
    mean_m.push_back(map.first_mean_m);
    best_mean_m.push_back(map.mean_m);
    heading_deg.push_back(deg_from_rad(map.heading_mean_rad));
    num_unjoined += map.num_unjoined;
    closures += map.closures;
  }
  return {name,
          spread_cell(final_m, 3),
          spread_cell(mean_m, 3),
          spread_cell(best_mean_m, 3),
          spread_cell(heading_deg, 3),
          fmt::format("{}", num_unjoined),
          fmt::format("{}", closures.num_accepted),
          fmt::format("{} ({})", closures.num_wrong, closures.num_wrong_heavy)};
}

std::string mapper_text(const CircuitStudy& study) {
  TextTable table{
      "The full mapper: errors in m and deg, median, worst of the seeds; in brackets "
      "wrong closures of a weight above 0.3",
      {"",
       "first aligned: last pose",
       "mean",
       "best aligned: mean",
       "heading: mean",
       "pieces not joined",
       "closures",
       "wrong"},
      {}};
  table.rows.push_back(mapper_row("no odometry", study, &CircuitRun::mapper_errors));
  table.rows.push_back(mapper_row("with odometry", study, &CircuitRun::wheeled_errors));
  return text_of(table);
}

std::vector<std::string> heading_row(const std::string& name,
                                     const CircuitStudy& study,
                                     ChainOutcome CircuitRun::*outcome) {
  std::vector<double> mean_deg, end_deg, slope_deg, square_end_deg;
  std::size_t num_wrong_turns = 0;
  for (const CircuitRun& run : study.runs) {
    const HeadingErrors& heading = (run.*outcome).heading;
    mean_deg.push_back(deg_from_rad(heading.mean_rad));
    end_deg.push_back(deg_from_rad(heading.end_rad));
    slope_deg.push_back(std::abs(deg_from_rad(heading.slope_rad_per_100_m)));
    square_end_deg.push_back(deg_from_rad(heading.square_end_rad));
    num_wrong_turns += heading.num_wrong_turns;
  }
  return {name,
          number(median(mean_deg), 3),
          spread_cell(end_deg, 3),
          number(median(slope_deg), 4),
          fmt::format("{}", num_wrong_turns),
          spread_cell(square_end_deg, 3)};
}

std::string heading_text(const CircuitStudy& study) {
  TextTable table{
      "Heading against the truth in deg, median (and worst) of the seeds",
      {"method", "mean", "at the end", "|slope| per 100 m", "wrong turns", "at the end modulo 90"},
      {}};
  table.rows.push_back(heading_row("paper, literal", study, &CircuitRun::paper_literal));
  table.rows.push_back(heading_row("paper, in sequence", study, &CircuitRun::paper));
  table.rows.push_back(heading_row("default", study, &CircuitRun::ours));
  table.rows.push_back(heading_row("full mapper", study, &CircuitRun::mapper));
  table.rows.push_back(heading_row("full mapper, odometry", study, &CircuitRun::wheeled));
  return text_of(table);
}

// Where the scans do not tell.

std::string claim_cell(const DirectionClaim& claim) {
  if (claim.error_m.count == 0) return "-";
  const double sigma_m = median(claim.claimed_sigma_m);
  return fmt::format("{:.3f} / {}",
                     claim.error_m.mean(),
                     std::isfinite(sigma_m) ? number(sigma_m, 3) : "unbounded");
}

std::string honesty_text(const HonestyStudy& study) {
  TextTable table{"Places that do not determine the pose; the default matcher's answers",
                  {"place",
                   "pairs",
                   "matched",
                   "ambiguous",
                   "degenerate",
                   "no overlap",
                   "too few points",
                   "wrong matched",
                   "along: error / claim [m]",
                   "across [m]"},
                  {}};
  for (const HonestyOutcome& outcome : study.outcomes) {
    std::vector<std::string> row = {outcome.name, fmt::format("{}", outcome.num_pairs)};
    for (const MatchStatus status : kAnswerStatuses) {
      row.push_back(fmt::format("{}", outcome.status_counts[static_cast<std::size_t>(status)]));
    }
    row.push_back(fmt::format("{}", outcome.num_wrong));
    row.push_back(claim_cell(outcome.along));
    row.push_back(claim_cell(outcome.across));
    table.rows.push_back(row);
  }
  return text_of(table);
}

}  // namespace

std::string paper_text(const PaperExperiment& experiment) {
  std::string text;
  if (experiment.hallways) text += hallway_text(*experiment.hallways) + "\n";
  if (experiment.buildings) text += building_text(*experiment.buildings) + "\n";
  if (experiment.factors) text += factor_text(*experiment.factors) + "\n";
  if (experiment.circuits) {
    const CircuitStudy& study = *experiment.circuits;
    text += closure_text(study) + mapper_text(study) + heading_text(study) + "\n";
  }
  if (experiment.honesty) text += honesty_text(*experiment.honesty) + "\n";
  return text + fmt::format("{:.1f} s\n", experiment.timing.at("all_s").get<double>());
}

}  // namespace setsquare::experiments
