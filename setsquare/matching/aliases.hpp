// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from answer, its only caller: the rule, tested with scans of its kind of place.
#pragma once

#include <span>
#include <vector>

#include "setsquare/matching/candidates.hpp"
#include "setsquare/matching/match_params.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {

/// Motions A in the reference's frame, best first, under which the place looks the same: A times
/// the best candidate is another candidate that the scans agree on and hardly contradict, and both
/// scans, moved by A onto themselves, agree with themselves. Walls along the motion agree with
/// themselves under any motion; so walls across it must hold each of the three poses.
/// `tight_m`: wall that agrees closely at the answer. For a row of niches or doors.
[[nodiscard]] std::vector<Pose2> find_aliases(const PreparedScan& reference,
                                              const PreparedScan& current,
                                              std::span<const Candidate> candidates,
                                              double tight_m,
                                              const AliasParams& params);

}  // namespace setsquare
