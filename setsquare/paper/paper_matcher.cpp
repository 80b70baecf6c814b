// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/paper/paper_matcher.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "setsquare/core/error.hpp"
#include "setsquare/paper/thinning.hpp"
#include "setsquare/scan/scan_to_points.hpp"

namespace setsquare {
namespace {

/// The paper weighs neither free space nor overlap.
constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

}  // namespace
void PaperParams::validate() const {
  if (!(min_spacing_m > 0.0) || !std::isfinite(min_spacing_m)) {
    throw ParameterError("min_spacing_m", "must be positive");
  }
  direction().validate();
  shifts().validate(bins());
  if (!(max_rotation_rad >= 0.25 * kPi && max_rotation_rad <= kPi)) {
    throw ParameterError("max_rotation_rad", "must lie between an eighth and half of a turn");
  }
  if (!(min_zncc_product >= 0.0 && min_zncc_product < 1.0)) {
    throw ParameterError("min_zncc_product", "must lie in [0, 1)");
  }
  if (min_num_points < 1) throw ParameterError("min_num_points", "must be positive");
}

PreparedPaperScan prepare_paper(const Scan& scan, const PaperParams& params) {
  PreparedPaperScan prepared;
  prepared.points = thin(points_from_scan(scan), params.min_spacing_m);          // Section 4.2
  prepared.direction = dominant_direction(prepared.points, params.direction());  // Algorithm 2
  prepared.projected =
      project_scan(prepared.points, prepared.direction.theta_rad, params.bins());  // Eqs. (4)-(6)
  return prepared;
}

MatchResult match_paper(const PreparedPaperScan& reference,
                        const PreparedPaperScan& current,
                        const PaperParams& params,
                        RelativePoseTrace* trace) {
  MatchResult result;
  result.agreement = result.contradiction = result.overlap = kNotMeasured;
  const std::size_t num_points = std::min(reference.points.size(), current.points.size());
  if (num_points < static_cast<std::size_t>(params.min_num_points)) return result;
  result.status = MatchStatus::kRejected;
  const std::optional<RelativePose> best = relative_pose(reference.projected,
                                                         current.projected,
                                                         params.shifts(),
                                                         params.max_rotation_rad,
                                                         trace);  // Algorithm 3
  if (!best) return result;
  result.T_reference_current = best->T_reference_current;
  result.zncc_x = best->zncc_x;
  result.zncc_y = best->zncc_y;
  // Section 4.4.1; two negative values make no success.
  result.score = std::max(best->zncc_x, 0.0) * std::max(best->zncc_y, 0.0);
  if (result.score > params.min_zncc_product) result.status = MatchStatus::kMatched;
  return result;
}

MatchResult match_paper(const Scan& reference,
                        const Scan& current,
                        const PaperParams& params,
                        RelativePoseTrace* trace) {
  params.validate();
  return match_paper(
      prepare_paper(reference, params), prepare_paper(current, params), params, trace);
}

}  // namespace setsquare
