// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/headings/proposals.hpp"

#include <algorithm>

#include "setsquare/scan/scan_to_points.hpp"

namespace setsquare {

void share_place(double share_of_place, HeadingEvidence& keyframe) {
  keyframe.share_of_place *= share_of_place;
  for (HeadingProposal& proposal : keyframe.proposals) proposal.confidence *= share_of_place;
}

std::vector<HeadingProposal> heading_proposals(const Scan& scan,
                                               const SquareDirectionParams& params,
                                               double confident_margin) {
  const SquareDirections directions =
      square_directions(points_from_scan(scan), scan.bearing_step_rad, params);
  const double confidence =
      std::clamp((directions.margin() - 1.0) / (confident_margin - 1.0), 0.0, 1.0);
  if (directions.peaks.empty() || confidence <= 0.0) return {};
  const SquareDirection& peak = directions.peaks.front();
  return {{peak.theta_rad, peak.sigma_rad, confidence}};
}

}  // namespace setsquare
