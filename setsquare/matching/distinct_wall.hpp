// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/surfaces/alignment.hpp"

namespace setsquare {

/// Length of wall, in m, on which two scans agree at a relative pose, where no straight line counts
/// for more than half a metre. Two walls of ten metres fit any corner of any building; twenty short
/// pieces on twenty lines fit one place.
[[nodiscard]] double distinct_wall_m(const AlignedScan& reference,
                                     const AlignedScan& current,
                                     const Pose2& T_reference_current);

}  // namespace setsquare
