// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "experiments/circuit_report.hpp"
#include "experiments/page_elements.hpp"
#include "experiments/tally.hpp"
#include "setsquare/drawing/text.hpp"

namespace setsquare::experiments {
namespace {

/// Median and worst.
std::string spread(const std::vector<double>& values, int digits) {
  return joined({number(median(values), digits),
                 ", ",
                 number(*std::max_element(values.begin(), values.end()), digits)});
}

std::vector<Cell> mapper_row(const std::string& name,
                             const CircuitStudy& study,
                             MapErrors CircuitRun::*errors) {
  std::vector<double> final_m, mean_m, best_mean_m, best_max_m, heading_mean, heading_max;
  std::size_t num_lost = 0;
  std::size_t num_unjoined = 0;
  ClosureCounts closures;
  for (const CircuitRun& run : study.runs) {
    const MapErrors& map = run.*errors;
    final_m.push_back(map.first_final_m);
    mean_m.push_back(map.first_mean_m);
    best_mean_m.push_back(map.mean_m);
    best_max_m.push_back(map.highest_m);
    heading_mean.push_back(deg_from_rad(map.heading_mean_rad));
    heading_max.push_back(deg_from_rad(map.heading_highest_rad));
    num_lost += map.num_lost;
    num_unjoined += map.num_unjoined;
    closures += map.closures;
  }
  return {{name},
          {spread(final_m, 3)},
          {spread(mean_m, 3)},
          {spread(best_mean_m, 3)},
          {spread(best_max_m, 3)},
          {spread(heading_mean, 3)},
          {spread(heading_max, 2)},
          {number(num_lost)},
          {number(num_unjoined), num_unjoined == 0 ? "" : "bad"},
          {number(closures.num_accepted)},
          {joined({number(closures.num_wrong), " (", number(closures.num_wrong_heavy), ")"}),
           closures.num_wrong == 0 ? "" : "bad"}};
}

}  // namespace

Table mapper_table(const CircuitStudy& study) {
  Table table{
      "The full mapper: errors in m and deg, median and worst of the seeds. First aligned: the "
      "first pose laid onto the truth, its heading with it; best aligned: the track as a whole. "
      "Closures are wrong beyond 0.3 m or 5 deg; in brackets those of a weight above 0.3",
      {"",
       "first aligned: last pose",
       "mean of all poses",
       "best aligned: mean",
       "highest",
       "heading: mean",
       "highest",
       "lost scans",
       "pieces not joined",
       "closures",
       "of those wrong"},
      {}};
  table.rows.push_back(mapper_row("no odometry", study, &CircuitRun::mapper_errors));
  table.rows.push_back(mapper_row("with odometry", study, &CircuitRun::wheeled_errors));
  return table;
}

std::string circuit_mapper_html(const CircuitStudy& study) {
  std::string html = paragraph(
      "The full mapper (setsquare map) has the same scans: it tracks against a submap, fuses "
      "headings, closes loops, and solves for all positions. Its odometry is that of wheels which "
      "drift (setsquare simulate). The track of 1.1 km sees most of its places once or twice.");
  html += table_html(mapper_table(study));
  html += figure(png_element(study.mapper_map, "Map by the full mapper"),
                 "The map by the full mapper, without odometry, seed 1.");
  return html;
}

}  // namespace setsquare::experiments
