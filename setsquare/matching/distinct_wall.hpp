// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from answer, its only caller, because tests compare it with a plain twin.
#pragma once

#include "setsquare/matching/match_params.hpp"
#include "setsquare/surfaces/alignment.hpp"

namespace setsquare {

/// Length of wall, in m, on which two scans agree at a relative pose, where no straight line counts
/// for more than params.max_line_m. Two walls of ten metres fit any corner of any building; twenty
/// short pieces on twenty lines fit one place.
[[nodiscard]] double distinct_wall_m(const AlignedScan& reference,
                                     const AlignedScan& current,
                                     const Pose2& T_reference_current,
                                     const DistinctWallParams& params = {});

}  // namespace setsquare
