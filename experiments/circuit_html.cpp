// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "experiments/chart.hpp"
#include "experiments/circuit_report.hpp"
#include "experiments/page_elements.hpp"
#include "experiments/plan_figure.hpp"
#include "experiments/tally.hpp"
#include "setsquare/drawing/text.hpp"

namespace setsquare::experiments {
namespace {

std::string closure_text(const ClosureMedians& medians, std::size_t circuit) {
  return joined({number(medians.x_m[circuit], 3),
                 ", ",
                 number(medians.y_m[circuit], 3),
                 "; ",
                 number(medians.norm_m[circuit], 3)});
}

Table closure_table(const CircuitStudy& study) {
  const ClosureMedians paper = closure_medians(study, &CircuitRun::paper);
  const ClosureMedians literal = closure_medians(study, &CircuitRun::paper_literal);
  const ClosureMedians ours = closure_medians(study, &CircuitRun::ours);
  const ClosureMedians mapper = closure_medians(study, &CircuitRun::mapper);
  Table table{joined({"Closure errors |x|, |y|; norm in m, median of ",
                      number(study.runs.size()),
                      " seeds; no loop closed but by the full mapper"}),
              {"circuit",
               "length here [m]",
               "paper, as stated",
               "here: --preset paper, literal",
               "here: --preset paper, in sequence",
               "here: default, scan to scan",
               "full mapper"},
              {}};
  const char* stated[] = {"0.3, 0.8; 0.85", "0.5, 1.2; 1.30"};
  for (std::size_t c = 0; c < 2; ++c) {
    const CircuitScans& circuit = study.runs.front().circuits[c];
    table.rows.push_back({{circuit.order},
                          {number(circuit.length_m, 1)},
                          {stated[c], "faint"},
                          {closure_text(literal, c)},
                          {closure_text(paper, c)},
                          {closure_text(ours, c)},
                          {closure_text(mapper, c)}});
  }
  return table;
}

std::vector<Cell> heading_row(const std::string& name,
                              const CircuitStudy& study,
                              ChainOutcome CircuitRun::*outcome) {
  std::vector<double> mean, highest, end, slope, square_mean, square_end, square_slope;
  std::size_t num_wrong_turns = 0;
  for (const CircuitRun& run : study.runs) {
    const HeadingErrors& heading = (run.*outcome).heading;
    mean.push_back(deg_from_rad(heading.mean_rad));
    highest.push_back(deg_from_rad(heading.highest_rad));
    end.push_back(deg_from_rad(heading.end_rad));
    slope.push_back(std::abs(deg_from_rad(heading.slope_rad_per_100_m)));
    square_mean.push_back(deg_from_rad(heading.square_mean_rad));
    square_end.push_back(deg_from_rad(heading.square_end_rad));
    square_slope.push_back(std::abs(deg_from_rad(heading.square_slope_rad_per_100_m)));
    num_wrong_turns += heading.num_wrong_turns;
  }
  const auto worst = [](const std::vector<double>& values) {
    return number(*std::max_element(values.begin(), values.end()), 3);
  };
  return {{name},
          {number(median(mean), 3)},
          {joined({number(median(highest), 2), ", ", worst(highest)})},
          {joined({number(median(end), 3), ", ", worst(end)})},
          {number(median(slope), 4)},
          {number(num_wrong_turns), num_wrong_turns == 0 ? "" : "bad"},
          {number(median(square_mean), 3)},
          {joined({number(median(square_end), 3), ", ", worst(square_end)})},
          {number(median(square_slope), 4)}};
}

Table heading_table(const CircuitStudy& study) {
  Table table{
      "Heading against the truth in deg, median of the seeds. A wrong turn is a step whose "
      "rotation is off by more than 45 deg; modulo 90 deg such steps do not count: that is what "
      "the directions of the walls hold fast",
      {"method",
       "mean",
       "highest on the way: median, worst",
       "at the end: median, worst",
       "|slope| per 100 m",
       "wrong turns, all seeds",
       "modulo 90 deg: mean",
       "at the end: median, worst",
       "|slope| per 100 m"},
      {}};
  table.rows.push_back(
      heading_row("here: --preset paper, literal", study, &CircuitRun::paper_literal));
  table.rows.push_back(heading_row("here: --preset paper, in sequence", study, &CircuitRun::paper));
  table.rows.push_back(heading_row("here: default", study, &CircuitRun::ours));
  table.rows.push_back(heading_row("here: full mapper", study, &CircuitRun::mapper));
  table.rows.push_back(heading_row("here: full mapper, odometry", study, &CircuitRun::wheeled));
  return table;
}

/// The seeds whose track in sequence ends in a wrong heading, and why.
std::string failing_seeds(const CircuitStudy& study) {
  const HeadingJudgement judgement = judge_headings(study, &CircuitRun::paper);
  if (judgement.failing.empty()) {
    return paragraph("In sequence, every seed's heading ends within 0.5 deg.");
  }
  Table table{"In sequence: seeds whose heading is off by more than 0.5 deg at the end",
              {"seed", "why", "at the end [deg]", "modulo 90 deg"},
              {}};
  for (const CircuitRun* run : judgement.failing) {
    const HeadingErrors& heading = run->paper.heading;
    const bool is_direction = deg_from_rad(heading.square_end_rad) > kMaxEndHeading_deg;
    table.rows.push_back({{number(run->seed)},
                          {is_direction ? "wrong direction of the last scans"
                                        : joined({number(heading.num_wrong_turns),
                                                  " wrong quarter turns along the way"})},
                          {number(deg_from_rad(heading.end_rad), 2)},
                          {number(deg_from_rad(heading.square_end_rad), 2)}});
  }
  return table_html(table);
}

std::vector<Cell> count_row(const std::string& name,
                            const CircuitStudy& study,
                            ChainOutcome CircuitRun::*outcome) {
  ChainCounts counts;
  for (const CircuitRun& run : study.runs) counts += (run.*outcome).chain.counts;
  return {{name},
          {number(counts.num_matched)},
          {number(counts.num_degenerate)},
          {number(counts.num_ambiguous)},
          {number(counts.num_unmatched)}};
}

std::string count_table(const CircuitStudy& study) {
  Table table{
      "How the scans of all seeds were placed: 'degenerate' keeps the last motion along one "
      "direction, 'ambiguous' takes of two poses the one nearer to the last motion, the rest keeps "
      "the last motion (paper: stands still)",
      {"method", "matched", "degenerate", "ambiguous", "unmatched"},
      {}};
  table.rows.push_back(
      count_row("here: --preset paper, literal", study, &CircuitRun::paper_literal));
  table.rows.push_back(count_row("here: --preset paper, in sequence", study, &CircuitRun::paper));
  table.rows.push_back(count_row("here: default", study, &CircuitRun::ours));
  table.rows.push_back(count_row("here: full mapper", study, &CircuitRun::mapper));
  table.rows.push_back(count_row("here: full mapper, odometry", study, &CircuitRun::wheeled));
  return table_html(table);
}

Series error_series(const std::string& name, const CircuitRun& run, const ChainOutcome& outcome) {
  const std::vector<double> path_m = travelled_m(run.truth);
  Series series{name, {}};
  for (std::size_t k = 0; k < run.truth.size(); k += 10) {
    const Eigen::Vector2d error_m =
        outcome.chain.T_map_base[k].translation() - run.truth[k].translation();
    series.points.emplace_back(path_m[k], error_m.norm());
  }
  return series;
}

Series heading_series(const std::string& name, const CircuitRun& run, const ChainOutcome& outcome) {
  const std::vector<double> path_m = travelled_m(run.truth);
  Series series{name, {}};
  for (std::size_t k = 0; k < run.truth.size(); k += 5) {
    series.points.emplace_back(
        path_m[k],
        deg_from_rad(wrap_to_pi(outcome.chain.T_map_base[k].theta_rad - run.truth[k].theta_rad)));
  }
  return series;
}

std::string track_charts(const CircuitRun& run) {
  const double length_m = travelled_m(run.truth).back();
  const std::vector<Series> position = {error_series("--preset paper, in sequence", run, run.paper),
                                        error_series("default", run, run.ours),
                                        error_series("full mapper", run, run.mapper)};
  const std::vector<Series> heading = {
      heading_series("--preset paper, in sequence", run, run.paper),
      heading_series("default", run, run.ours),
      heading_series("full mapper", run, run.mapper)};
  return "<div class=\"charts\">\n" +
         chart_svg({"Position error along the track, seed 1",
                    "travelled [m]",
                    "[m]",
                    0,
                    length_m,
                    0,
                    highest_y(position, 0.5),
                    {},
                    position}) +
         chart_svg({"Heading error along the track, seed 1",
                    "travelled [m]",
                    "[deg]",
                    0,
                    length_m,
                    -1.0,
                    1.0,
                    {},
                    heading}) +
         "</div>\n";
}

std::string seed_table(const CircuitStudy& study) {
  Table table{"Norm of the closure errors in m, and heading error at the end in deg",
              {"seed",
               "paper, 1st",
               "paper, 2nd",
               "default, 1st",
               "default, 2nd",
               "full mapper, 1st",
               "full mapper, 2nd",
               "paper, literal, heading",
               "paper, in sequence, heading",
               "default, heading",
               "full mapper, heading"},
              {}};
  for (const CircuitRun& run : study.runs) {
    table.rows.push_back({{number(run.seed)},
                          {number(run.paper.closure_m[0].norm(), 3)},
                          {number(run.paper.closure_m[1].norm(), 3)},
                          {number(run.ours.closure_m[0].norm(), 3)},
                          {number(run.ours.closure_m[1].norm(), 3)},
                          {number(run.mapper.closure_m[0].norm(), 3)},
                          {number(run.mapper.closure_m[1].norm(), 3)},
                          {number(deg_from_rad(run.paper_literal.heading.end_rad), 3)},
                          {number(deg_from_rad(run.paper.heading.end_rad), 3)},
                          {number(deg_from_rad(run.ours.heading.end_rad), 3)},
                          {number(deg_from_rad(run.mapper.heading.end_rad), 3)}});
  }
  return folding("Every seed", table_html(table));
}

}  // namespace

std::string circuit_html(const CircuitStudy& study) {
  const CircuitRun& first = study.runs.front();
  std::string html = paragraph(
      joined({"A building of 136 x 236 m and a track of ",
              number(travelled_m(first.truth).back(), 0),
              " m through it; ",
              number(first.truth.size()),
              " scans of a UTM-30LX, 0.4 m or 10 deg apart, each matched with the one before. No "
              "loop is closed (but by the full mapper), no odometry used; the default matcher's "
              "headings are fused with the "
              "directions of the walls. A closure error is the difference between the estimated "
              "and the true relative pose of the end of a circuit, seen from its start."}));
  html += paragraph(
      "The paper does not tell how its track chose among Algorithm 3's four offsets. 'Literal' "
      "lets the largest product decide, as printed for a pair of unknown rotation: now and then a "
      "quarter or half turn wins, and from there on the track runs another way. 'In sequence' is "
      "our reading of section 5.2, and what setsquare map --preset paper does: neighbouring scans "
      "cannot have turned by more than 45 deg, so the nearest offset is the one. In both, a "
      "scan whose dominant direction is a wrong one is off by itself (the highest errors below) "
      "and bends the track there, but the next right one has its heading from its own walls again. "
      "A "
      "rejected scan stands still; after four in a row the last one starts anew with the heading "
      "that its walls measure.");
  html += command_line("setsquare experiment paper --only section_5_2 -o out");
  html += table_html(closure_table(study));
  html += table_html(heading_table(study));
  html += failing_seeds(study);
  html += count_table(study);
  html += track_charts(first);
  html += seed_table(study);
  html += figure(plan_svg(study.plan,
                          {{"true track", first.truth},
                           {"--preset paper, in sequence", first.paper.chain.T_map_base},
                           {"default", first.ours.chain.T_map_base},
                           {"full mapper", first.mapper.chain.T_map_base}}),
                 "Figure 5: the track in the building of seed 1.");
  html += figure(png_element(study.default_map, "Map by the default matcher"),
                 "Figure 6: the map by the default matcher, scan to scan, seed 1.");
  html += figure(png_element(study.paper_map, "Map by the paper's method"),
                 "The same by the paper's method, in sequence.");
  html += circuit_mapper_html(study);
  return html;
}

std::string circuit_text(const CircuitStudy& study) {
  return table_text(closure_table(study)) + table_text(mapper_table(study)) +
         table_text(heading_table(study));
}

}  // namespace setsquare::experiments
