// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/matching/match_result.hpp"
#include "setsquare/matching/paper_params.hpp"
#include "setsquare/matching/relative_pose.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {

/// A scan prepared once for any number of matches by the paper's method.
struct PreparedPaperScan {
  PointSet points;              ///< Thinned, in the sensor frame.
  DominantDirection direction;  ///< Algorithm 2.
  ProjectedScan projected;      ///< Along the dominant direction and across it.
};

/// ThinOut, GetDominantDirection and the profiles. The parameters are valid (PaperParams).
[[nodiscard]] PreparedPaperScan prepare_paper(const Scan& scan, const PaperParams& params = {});

/// The paper's method as printed (bando2014), Algorithm 1 with both scans prepared by the same
/// parameters. Status kMatched where the product of the axes' ZNCCs exceeds the threshold,
/// kRejected where not, kTooFewPoints where a scan has next to none. `score` is the product; the
/// information stays zero, for the paper gives none. `trace`, if any, receives what Algorithm 3
/// saw (left as it was where it did not run).
[[nodiscard]] MatchResult match_paper(const PreparedPaperScan& reference,
                                      const PreparedPaperScan& current,
                                      const PaperParams& params = {},
                                      RelativePoseTrace* trace = nullptr);

/// The same from scans. Throws ParameterError where a parameter is outside its domain.
[[nodiscard]] MatchResult match_paper(const Scan& reference,
                                      const Scan& current,
                                      const PaperParams& params = {},
                                      RelativePoseTrace* trace = nullptr);

}  // namespace setsquare
