// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/heading_assignment.hpp"

#include <cmath>

#include "setsquare/core/angle.hpp"

namespace setsquare {

std::vector<AssignedProposal> assign_heading_proposals(
    const std::vector<HeadingEvidence>& keyframes,
    const HeadingFrames& found,
    double period_rad,
    double gate_rad,
    double building_sigma_rad) {
  const double trust = found.share * found.share;
  std::vector<AssignedProposal> measurements;
  for (std::size_t k = 0; k < keyframes.size(); ++k) {
    for (const HeadingProposal& proposal : keyframes[k].proposals) {
      const double variance_rad2 =
          proposal.sigma_rad * proposal.sigma_rad + building_sigma_rad * building_sigma_rad;
      AssignedProposal measurement{.keyframe = k};
      double least_rad = gate_rad;
      for (std::size_t f = 0; f < found.frames.size(); ++f) {
        const double rough_rad = found.drift_rad[k] + found.frames[f].offset_rad;
        const double miss_rad = wrap_to_period(
            proposal.heading_rad - keyframes[k].tracked_heading_rad - rough_rad, period_rad);
        if (std::abs(miss_rad) >= least_rad) continue;
        least_rad = std::abs(miss_rad);
        measurement = {k, f, rough_rad + miss_rad, trust * proposal.confidence / variance_rad2};
      }
      if (measurement.information > 0.0) measurements.push_back(measurement);
    }
  }
  return measurements;
}

}  // namespace setsquare
