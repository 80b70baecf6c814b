// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "setsquare/drawing/text.hpp"
#include "setsquare/report/match/figures/figures.hpp"
#include "setsquare/report/palette.hpp"

namespace setsquare {
namespace {

constexpr double kRow_px = 22.0;
constexpr double kNumberColumn_px = 108.0;
constexpr double kFirstColumn_px = 52.0;

/// Where each column's text stands: numbers end there, words begin there.
std::vector<double> places_of_columns(const StoryTable& table) {
  std::vector<double> places_px;
  const std::size_t num_columns = table.head.size();
  for (std::size_t column = 0; column < num_columns; ++column) {
    const bool is_words = !table.has_numbers || column + 1 == num_columns;
    const double step_px =
        table.has_numbers ? kNumberColumn_px : kFigureWidth_px / static_cast<double>(num_columns);
    const double first_px = table.has_numbers ? kFirstColumn_px : 20.0;
    const double place_px = first_px + step_px * static_cast<double>(column);
    places_px.push_back(is_words && table.has_numbers ? place_px - step_px + 36.0 : place_px);
  }
  return places_px;
}

}  // namespace

StoryTable proposal_table(const MatchStory& story) {
  StoryTable table;
  table.head = {"#", "x [m]", "y [m]", "rotation [deg]"};
  table.head.insert(table.head.end(), story.measure_names.begin(), story.measure_names.end());
  table.head.emplace_back("outcome");
  for (const StoryProposal& proposal : story.proposals) {
    const Pose2& pose = proposal.T_reference_current;
    std::vector<std::string> row = {std::to_string(table.rows.size() + 1),
                                    fixed(pose.x_m, 3),
                                    fixed(pose.y_m, 3),
                                    fixed(deg_from_rad(pose.theta_rad), 2)};
    row.insert(row.end(), proposal.measures.begin(), proposal.measures.end());
    row.push_back(proposal.fate);
    table.rows.push_back(std::move(row));
  }
  return table;
}

StoryTable rule_table(const SurfaceEvidence& looked_at) {
  StoryTable table;
  table.head = {"rule", "asked", "found", "outcome"};
  table.has_numbers = false;
  table.marked_row = looked_at.rules.size();
  for (const VerdictRule& rule : looked_at.rules) {
    const bool is_first_failure = !rule.holds && table.marked_row == looked_at.rules.size();
    if (is_first_failure) table.marked_row = table.rows.size();
    table.rows.push_back({rule.name,
                          rule.asked,
                          rule.found,
                          rule.holds ? "holds"
                                     : fmt::format("fails: {}{}",
                                                   to_string(rule.otherwise),
                                                   is_first_failure ? ", which decides" : "")});
  }
  return table;
}

Figure table_figure(const StoryTable& table) {
  const auto num_rows = static_cast<double>(table.rows.size() + 1);
  SvgCanvas canvas(kFigureWidth_px, kRow_px * num_rows + 8.0);
  const std::vector<double> places_px = places_of_columns(table);
  const auto draw_row = [&](const std::vector<std::string>& cells,
                            double row,
                            bool is_bold,
                            Color ink) {
    for (std::size_t column = 0; column < cells.size(); ++column) {
      const bool is_words = !table.has_numbers || column + 1 == cells.size();
      canvas.text({places_px[column], kRow_px * row + 15.0},
                  cells[column],
                  {.size_px = 12.5,
                   .fill = ink,
                   .anchor = is_words ? TextAnchor::kStart : TextAnchor::kEnd,
                   .is_bold = is_bold});
    }
    const double line_px = kRow_px * (row + 1.0);
    canvas.line({20.0, line_px}, {kFigureWidth_px - 10.0, line_px}, {.stroke = palette::kGuide});
  };
  draw_row(table.head, 0.0, true, palette::kInk);
  const Color mark = table.has_numbers ? palette::kAnswer : palette::kLost;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const bool is_marked = row == table.marked_row;
    draw_row(
        table.rows[row], static_cast<double>(row + 1), is_marked, is_marked ? mark : palette::kInk);
  }
  return {canvas};
}

}  // namespace setsquare
