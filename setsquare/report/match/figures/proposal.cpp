// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>
#include <vector>

#include "setsquare/drawing/text.hpp"
#include "setsquare/report/match/figures/figures.hpp"
#include "setsquare/report/match/figures/proposal_table.hpp"
#include "setsquare/report/palette.hpp"

namespace setsquare {
namespace {

constexpr double kRow_px = 22.0;
constexpr double kNumberColumn_px = 120.0;
constexpr double kFirstColumn_px = 52.0;

}  // namespace

std::vector<std::string> proposal_table_head(const MatchStory& story) {
  std::vector<std::string> head = {"#", "x [m]", "y [m]", "rotation [deg]"};
  head.insert(head.end(), story.measure_names.begin(), story.measure_names.end());
  head.emplace_back("outcome");
  return head;
}

std::vector<std::string> proposal_table_row(const MatchStory& story, std::size_t proposal) {
  const StoryProposal& shown = story.proposals[proposal];
  const Pose2& pose = shown.T_reference_current;
  std::vector<std::string> row = {std::to_string(proposal + 1),
                                  fixed(pose.x_m, 3),
                                  fixed(pose.y_m, 3),
                                  fixed(deg_from_rad(pose.theta_rad), 2)};
  row.insert(row.end(), shown.measures.begin(), shown.measures.end());
  row.push_back(shown.fate);
  return row;
}

SvgCanvas proposal_figure(const MatchStory& story) {
  const auto num_rows = static_cast<double>(story.proposals.size() + 1);
  SvgCanvas canvas(kFigureWidth_px, kRow_px * num_rows + 8.0);
  const auto draw_row = [&](const std::vector<std::string>& cells, std::size_t row, bool is_bold) {
    const double baseline_px = kRow_px * static_cast<double>(row) + 15.0;
    for (std::size_t column = 0; column < cells.size(); ++column) {
      const bool is_words = column + 1 == cells.size();
      const double right_px = kFirstColumn_px + kNumberColumn_px * static_cast<double>(column);
      const double left_px = right_px - kNumberColumn_px + 36.0;
      canvas.text({is_words ? left_px : right_px, baseline_px},
                  cells[column],
                  {.size_px = 12.5,
                   .fill = row == 1 ? palette::kAnswer : palette::kInk,
                   .anchor = is_words ? TextAnchor::kStart : TextAnchor::kEnd,
                   .is_bold = is_bold});
    }
    const double line_px = kRow_px * static_cast<double>(row + 1);
    canvas.line({20.0, line_px}, {kFigureWidth_px - 10.0, line_px}, {.stroke = palette::kGuide});
  };
  draw_row(proposal_table_head(story), 0, true);
  for (std::size_t i = 0; i < story.proposals.size(); ++i) {
    draw_row(proposal_table_row(story, i), i + 1, i == 0);
  }
  return canvas;
}

}  // namespace setsquare
