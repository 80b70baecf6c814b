// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "setsquare/headings/evidence.hpp"
#include "setsquare/headings/square_direction.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// What the walls of a scan propose for its sensor's heading in the building: the highest peak of
/// their directions, believed by its margin over the next one, not at all at 1 and fully at
/// `confident_margin`; nothing without a margin.
[[nodiscard]] std::vector<HeadingProposal> heading_proposals(const Scan& scan,
                                                             const SquareDirectionParams& params,
                                                             double confident_margin);

/// Makes a keyframe count as this share of one. Walls that are off square are so for each scanner:
/// counted in full, the headings would follow them the closer the more scanners see them.
void share_place(double share_of_place, HeadingEvidence& keyframe);

}  // namespace setsquare
