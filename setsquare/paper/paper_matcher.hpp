// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "setsquare/paper/dominant_direction.hpp"
#include "setsquare/paper/profile_correlation.hpp"
#include "setsquare/paper/relative_pose.hpp"
#include "setsquare/scan/match_result.hpp"
#include "setsquare/scan/scan.hpp"

namespace setsquare {
/// The constants of the paper (bando2014, sections 4.2, 4.3.2 and 5.1), its values as defaults.
struct PaperParams {
  double min_spacing_m = 0.08;                    ///< Thinning, section 4.2.
  double bin_width_m = 0.04;                      ///< Delta rho, section 4.3.2.
  double max_distance_m = 10.0;                   ///< d_max, section 4.3.2.
  double direction_step_rad = rad_from_deg(0.1);  ///< Of theta in Algorithm 2.
  /// Reading of eq. (7); docs/method.md gives the reasons.
  DirectionMoment moment = DirectionMoment::kNeighbourDifferences;
  double max_shift_m = 2.5;     ///< lambda_max, section 5.1.
  double shift_step_m = 0.005;  ///< Delta lambda, section 5.1.
  /// Offsets of Algorithm 3 that turn the current scan by more (eq. (8), either way) are not tried.
  /// Half a turn is the method as printed, which tries all four.
  double max_rotation_rad = kPi;
  double min_zncc_product = 0.25;   ///< Of both axes; success lies above it.
  std::int32_t min_num_points = 2;  ///< Thinned points below which there is nothing to match.

  /// The bins of both profiles.
  [[nodiscard]] ProfileBins bins() const { return {bin_width_m, max_distance_m}; }
  /// What Algorithm 2 is run with.
  [[nodiscard]] DominantDirectionParams direction() const {
    return {bins(), direction_step_rad, moment};
  }
  /// What Algorithm 3 is run with.
  [[nodiscard]] ShiftSearch shifts() const { return {max_shift_m, shift_step_m}; }

  /// Throws ParameterError where a field is outside its domain.
  void validate() const;
};

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
/// information stays zero: the paper gives none. `trace`, if any, receives what Algorithm 3
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
