// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/matching/match_params.hpp"
#include "setsquare/scan/match_result.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

struct MatchTrace;    // setsquare/matching/trace.hpp
struct PreparedScan;  // setsquare/surfaces/prepared_scan.hpp, with prepare()

/// Relative pose of two scans, of which nothing is known: p_reference = T_reference_current *
/// p_current, in the sensors' frames. Uses the ranges and nothing else: no stamp, no mounting, no
/// preference for small motion.
///
/// 1. Propose: rotations under which the walls face the same ways, and for each every translation
///    of a window, correlated at once (CorrelationGrid).
/// 2. Verify in 2-D, both ways: agreement on surfaces, contradictions in free space.
/// 3. Refine the survivors point to line; the answer together with how the robot turned while the
///    sensor swept.
/// 4. Where nothing stands alone, search again over every rotation of the circle.
/// 5. Answer with evidence: status, information, runner-up.
///
/// Throws ParameterError where a parameter or a scan's geometry is outside its domain.
[[nodiscard]] MatchResult match(const Scan& reference,
                                const Scan& current,
                                const MatchParams& params = {});

/// The same from scans prepared once (`prepare`) with params.surface and params.samples; the
/// parameters are valid. `trace`, if any, receives what was considered.
[[nodiscard]] MatchResult match(const PreparedScan& reference,
                                const PreparedScan& current,
                                const MatchParams& params = {},
                                MatchTrace* trace = nullptr);

}  // namespace setsquare
