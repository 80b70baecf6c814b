// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/match/sections.hpp"

#include <fmt/core.h>

#include "setsquare/drawing/text.hpp"
#include "setsquare/surfaces/correlation_grid.hpp"

namespace setsquare {
namespace {

using Sections = std::vector<MatchSection>;

void add_table(std::string title, std::string caption, StoryTable table, Sections& sections) {
  Figure figure = table_figure(table);
  sections.push_back({std::move(title), std::move(caption), std::move(figure), std::move(table)});
}

Sections paper_sections(const MatchStory& story, const PaperEvidence& looked_at) {
  Sections sections;
  sections.push_back({"The two scans before and after thinning",
                      "Points nearer than 0.08 m to a kept one are dropped, so that density no "
                      "longer depends on range (the paper's Figure 3). Each in its sensor's frame; "
                      "the arrow is the sensor.",
                      thinning_figure(story, looked_at)});
  sections.push_back({"Direction curve M(theta)",
                      "Where the scan, turned by theta, has walls along the axis, its profile has "
                      "sharp peaks and M is high (eq. 7); theta_D is the highest point.",
                      direction_figure(looked_at)});
  sections.push_back({"Profiles at the dominant direction and off it",
                      "Points counted along one direction (eqs. 4-6; the paper's Figure 2): sharp "
                      "along the walls' directions, flat off them.",
                      profile_figure(looked_at)});
  sections.push_back({"Correlation against the shift",
                      "Of the two scans' profiles, along x' and y' of the reference, at the "
                      "answer's rotation and at the other offsets (eqs. 9 and 10). Rings: the "
                      "shifts that were chosen.",
                      correlation_figure(looked_at)});
  add_table("Proposals, and why they lost", story.remark, proposal_table(story), sections);
  return sections;
}

std::string words_of_search(const SurfaceEvidence& looked_at) {
  const MatchParams& params = looked_at.params;
  const SearchParams& search = looked_at.trace.was_thorough ? params.thorough : params.quick;
  return fmt::format(
      "At each rotation all translations are correlated on a grid of {} m; the best {} are refined "
      "and "
      "scored with the coarse samples, the best {} of those with the fine ones.",
      fixed(CorrelationGrid::kCell_m, 1),
      search.num_coarse,
      search.num_fine);
}

Sections surface_sections(const MatchStory& story, const SurfaceEvidence& looked_at) {
  Sections sections;
  sections.push_back({"The two scans as surfaces",
                      "Neighbouring returns that lie on one surface are joined, and a line is "
                      "fitted at each return. Each scan in its sensor's frame; the arrow is the "
                      "sensor.",
                      surface_figure(looked_at)});
  sections.push_back(
      {"Rotations that are proposed",
       "The peaks of the correlation (rings) are the rotations at which the walls of "
       "both scans face the same ways. Where no answer stands, the whole circle is "
       "searched.",
       rotation_figure(story, looked_at)});
  sections.push_back(
      {"From proposals to the answer", words_of_search(looked_at), search_figure(looked_at)});
  add_table("Proposals, and why they lost", story.remark, proposal_table(story), sections);
  sections.push_back(
      {"What the scores are made of",
       "The fine samples of either scan against the other: on its surface (agreeing), near it, "
       "hidden behind it, outside its view, or where it saw through (contradicted).",
       evidence_figure(looked_at)});
  add_table("The verdict, and the rule that decided",
            "The rules are asked in this order; the first that fails decides. Where all hold, the "
            "scans are matched.",
            rule_table(looked_at),
            sections);
  return sections;
}

}  // namespace

std::vector<MatchSection> match_sections(const MatchStory& story) {
  const auto* const paper = std::get_if<PaperEvidence>(&story.looked_at);
  Sections sections = paper != nullptr
                          ? paper_sections(story, *paper)
                          : surface_sections(story, std::get<SurfaceEvidence>(story.looked_at));
  sections.push_back(
      {"The two scans laid over each other",
       paper != nullptr ? "At the answer and, if there is one, at the best different pose. Marked "
                          "red: returns where the other scan saw through."
                        : "As the correlation proposed it, refined to the answer, and at the best "
                          "different pose. Marked red: returns where the other scan saw through.",
       overlay_figure(story)});
  for (std::size_t i = 0; i < sections.size(); ++i) {
    sections[i].title = fmt::format("{}. {}", i + 1, sections[i].title);
  }
  return sections;
}

std::string match_subtitle(const MatchStory& story) {
  return fmt::format("{}: {} (reference) and {} (current), preset {}",
                     story.names.log,
                     story.names.reference,
                     story.names.current,
                     story.preset);
}

}  // namespace setsquare
