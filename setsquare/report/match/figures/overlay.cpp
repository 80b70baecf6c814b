// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include "setsquare/drawing/text.hpp"
#include "setsquare/report/match/contradictions.hpp"
#include "setsquare/report/match/figures/figures.hpp"
#include "setsquare/report/match/figures/plot_panel.hpp"
#include "setsquare/report/match/figures/plotted_points.hpp"
#include "setsquare/report/match/story/words.hpp"
#include "setsquare/report/palette.hpp"

namespace setsquare {
namespace {

constexpr double kOverlayHeight_px = 620.0;

/// Where either scan contradicts the other, in the reference's frame.
std::vector<Eigen::Vector2d> contradicted_places(const MatchStory& story,
                                                 const Pose2& T_reference_current) {
  auto places = contradictions(story.reference.scan, story.current.points, T_reference_current);
  const Pose2 T_current_reference = T_reference_current.inverse();
  for (const Eigen::Vector2d& place :
       contradictions(story.current.scan, story.reference.points, T_current_reference)) {
    places.emplace_back(T_reference_current * place);
  }
  return places;
}

/// In the column of so many; the only one has the whole width.
void draw_overlay(SvgCanvas& canvas,
                  int column,
                  int num_columns,
                  const MatchStory& story,
                  const std::string& name,
                  const Pose2& T_reference_current) {
  const Eigen::Vector2d size(kFigureWidth_px / num_columns, kOverlayHeight_px);
  const auto reference = plotted_points(story.reference.points);
  const auto current = plotted_points(story.current.points, T_reference_current);
  std::vector<Eigen::Vector2d> all = reference;
  all.insert(all.end(), current.begin(), current.end());
  const EqualRanges ranges = equal_ranges(all, size);
  PlotPanel panel(canvas,
                  {size.x() * column, 0.0},
                  size,
                  ranges.x,
                  ranges.y,
                  {joined({name, ": ", words_of_pose(T_reference_current)}),
                   "x [m], reference sensor's frame",
                   column == 0 ? "y [m]" : ""});
  const auto contradicted = contradicted_places(story, T_reference_current);
  panel.dots(contradicted, palette::kContradiction, 4.0, 0.45);
  panel.dots(reference, palette::kReference, 2.0);
  panel.dots(current, palette::kCurrent, 1.6);
  panel.sensor({0.0, 0.0}, 0.0, palette::kReference);
  panel.sensor(T_reference_current.translation(), T_reference_current.theta_rad, palette::kCurrent);
  panel.remark("reference", palette::kReference, 0);
  panel.remark("current", palette::kCurrent, 1);
  panel.remark(
      joined({std::to_string(contradicted.size()), " returns where the other saw through"}),
      palette::kLost,
      2);
}

}  // namespace

const StoryProposal* best_other_proposal(const MatchStory& story) {
  if (story.proposals.empty()) return nullptr;
  constexpr double kSame_m = 0.3;
  constexpr double kSame_rad = 0.1;
  const Pose2 T_answer_reference = story.proposals.front().T_reference_current.inverse();
  for (const StoryProposal& proposal : story.proposals) {
    const Pose2 apart = T_answer_reference * proposal.T_reference_current;
    if (apart.translation().norm() > kSame_m || std::abs(apart.theta_rad) > kSame_rad) {
      return &proposal;
    }
  }
  return nullptr;
}

SvgCanvas overlay_figure(const MatchStory& story) {
  SvgCanvas canvas(kFigureWidth_px, kOverlayHeight_px);
  if (story.proposals.empty()) {
    canvas.text({52.0, 40.0}, "There is no pose at which to lay the scans over each other.");
    return canvas;
  }
  const StoryProposal* const other = best_other_proposal(story);
  const int num_columns = other != nullptr ? 2 : 1;
  draw_overlay(
      canvas, 0, num_columns, story, "Answer", story.proposals.front().T_reference_current);
  if (other != nullptr) {
    draw_overlay(canvas, 1, num_columns, story, "Runner-up", other->T_reference_current);
  }
  return canvas;
}

}  // namespace setsquare
