// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/match/sections.hpp"

#include "setsquare/drawing/text.hpp"
#include "setsquare/report/match/figures/figures.hpp"

namespace setsquare {

std::vector<MatchSection> match_sections(const MatchStory& story) {
  std::vector<MatchSection> sections;
  sections.push_back({"1. The two scans before and after thinning",
                      "Points nearer than 0.08 m to a kept one are dropped, so that density no "
                      "longer depends on range (the paper's Figure 3). Each in its sensor's frame; "
                      "the arrow is the sensor.",
                      scan_figure(story)});
  sections.push_back({"2. Direction curve M(theta)",
                      "Where the scan, turned by theta, has walls along the axis, its profile has "
                      "sharp peaks and M is high (eq. 7); theta_D is the highest point.",
                      direction_figure(story)});
  sections.push_back({"3. Profiles at the dominant direction and off it",
                      "Points counted along one direction (eqs. 4-6; the paper's Figure 2): sharp "
                      "along the walls' directions, flat off them.",
                      profile_figure(story)});
  sections.push_back(
      {"4. Correlation against the shift",
       "Of the two scans' profiles, along x' and y' of the reference, at the answer's "
       "rotation and at the best others (eqs. 9 and 10). Rings: the shifts that the "
       "proposals chose.",
       correlation_figure(story)});
  sections.push_back(
      {"5. Proposals, and why they lost", story.remark, proposal_figure(story), true});
  sections.push_back({"6. The two scans laid over each other",
                      "At the answer and, if there is one, at the best different pose. Marked red: "
                      "returns where the other scan saw through.",
                      overlay_figure(story)});
  return sections;
}

std::string match_subtitle(const MatchStory& story) {
  return joined({story.names.log,
                 ": ",
                 story.names.reference,
                 " (reference) and ",
                 story.names.current,
                 " (current), preset ",
                 story.preset});
}

}  // namespace setsquare
