// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from scan_matcher, its only caller, so that the pipeline there stays one call per step.
#pragma once

#include <span>

#include "setsquare/matching/candidates.hpp"
#include "setsquare/matching/match_params.hpp"
#include "setsquare/scan/match_result.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare {

struct MatchTrace;

/// The best candidate with its evidence, judged against the others (best first, may be empty).
/// `trace`, if any, receives what the verdict measured.
[[nodiscard]] MatchResult answer(const PreparedScan& reference,
                                 const PreparedScan& current,
                                 std::span<const Candidate> candidates,
                                 const MatchParams& params,
                                 MatchTrace* trace = nullptr);

/// The correlation of the two scans' profiles along and across the reference's dominant direction
/// at the given pose: evidence for a person, and the paper's measure.
struct AxisZncc {
  double x = 0.0;
  double y = 0.0;
};
[[nodiscard]] AxisZncc axis_zncc(const PreparedScan& reference,
                                 const PreparedScan& current,
                                 const Pose2& T_reference_current);

}  // namespace setsquare
