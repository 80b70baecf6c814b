// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/report/match/story/story.hpp"

namespace setsquare {

/// What the paper makes of a scan's returns: thinning, M(theta), dominant direction, profiles. The
/// matcher keeps none of it, so that it is computed once more for the pictures. Has a header for
/// the test that holds the two together.
[[nodiscard]] PaperScan paper_scan(const PointSet& points, const PaperParams& params);

}  // namespace setsquare
