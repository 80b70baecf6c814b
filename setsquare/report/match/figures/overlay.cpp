// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "setsquare/drawing/text.hpp"
#include "setsquare/report/match/contradictions.hpp"
#include "setsquare/report/match/figures/figures.hpp"
#include "setsquare/report/palette.hpp"
#include "setsquare/report/plot_panel.hpp"

namespace setsquare {
namespace {

constexpr double kOverlayHeight_px = 480.0;

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

SvgCanvas overlay_panel(const MatchStory& story,
                        const char* name,
                        const Pose2& T_reference_current,
                        double width_px) {
  const Eigen::Vector2d size(width_px, kOverlayHeight_px);
  SvgCanvas canvas(size.x(), size.y());
  const auto reference = plotted_points(story.reference.points);
  const auto current = plotted_points(story.current.points, T_reference_current);
  std::vector<Eigen::Vector2d> all = reference;
  all.insert(all.end(), current.begin(), current.end());
  const EqualRanges ranges = equal_ranges(all, size);
  PlotPanel panel(canvas,
                  {0.0, 0.0},
                  size,
                  ranges.x,
                  ranges.y,
                  {fmt::format("{}: x {} m, y {} m, {} deg",
                               name,
                               fixed(T_reference_current.x_m, 3),
                               fixed(T_reference_current.y_m, 3),
                               fixed(deg_from_rad(T_reference_current.theta_rad), 2)),
                   "x [m], reference sensor's frame",
                   "y [m]"});
  const auto contradicted = contradicted_places(story, T_reference_current);
  panel.dots(contradicted, palette::kContradiction, 4.0, 0.45);
  panel.dots(reference, palette::kReference, 2.0);
  panel.dots(current, palette::kCurrent, 1.6);
  panel.sensor({0.0, 0.0}, 0.0, palette::kReference);
  panel.sensor(T_reference_current.translation(), T_reference_current.theta_rad, palette::kCurrent);
  panel.remark("reference", palette::kReference, 0);
  panel.remark("current", palette::kCurrent, 1);
  panel.remark(fmt::format("{} returns where the other saw through", contradicted.size()),
               palette::kLost,
               2);
  return canvas;
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

Figure overlay_figure(const MatchStory& story) {
  if (story.proposals.empty()) {
    SvgCanvas canvas(kFigureWidth_px / 3.0, 60.0);
    canvas.text({52.0, 40.0}, "There is no pose at which to lay the scans over each other.");
    return {canvas};
  }
  std::vector<std::pair<const char*, Pose2>> shown;
  if (story.T_proposed) shown.emplace_back("Proposed", *story.T_proposed);
  shown.emplace_back("Answer", story.proposals.front().T_reference_current);
  const StoryProposal* const other = best_other_proposal(story);
  if (other != nullptr) shown.emplace_back("Runner-up", other->T_reference_current);
  const double width_px =
      kFigureWidth_px / static_cast<double>(std::max<std::size_t>(2, shown.size()));
  Figure figure;
  for (const auto& [name, T_reference_current] : shown) {
    figure.push_back(overlay_panel(story, name, T_reference_current, width_px));
  }
  return figure;
}

}  // namespace setsquare
