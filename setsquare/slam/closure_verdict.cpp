// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/slam/closure_verdict.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

/// Angle between a direction and an offset, modulo pi: 0 to pi / 2.
double angle_between(const Eigen::Vector2d& direction, const Eigen::Vector2d& offset_m) {
  const double along = std::abs(direction.dot(offset_m));
  const double across = std::abs(direction.x() * offset_m.y() - direction.y() * offset_m.x());
  return std::atan2(across, along);
}

/// Whether another pose lies along the weak direction from the best.
bool is_along(const SubmapFitBothWays& other,
              const SubmapMatch& match,
              const ClosureVerdictParams& params) {
  const Eigen::Vector2d offset_m =
      other.T_reference_current.translation() - match.best.T_reference_current.translation();
  return angle_between(match.weak.direction, offset_m) < params.max_runner_up_rad;
}

}  // namespace

void ClosureVerdictParams::validate() const {
  if (!(min_score > 0.0)) throw ParameterError("min_score", "must be positive");
  if (!(max_contradiction >= 0.0)) {
    throw ParameterError("max_contradiction", "must not be negative");
  }
  if (!(min_effective_points > 0.0)) {
    throw ParameterError("min_effective_points", "must be positive");
  }
}

std::string_view to_string(ClosureReason reason) {
  switch (reason) {
    case ClosureReason::kStandsAlone:
      return "stands alone";
    case ClosureReason::kOneAxis:
      return "one axis, open along the other";
    case ClosureReason::kNoPose:
      return "no pose in the window";
    case ClosureReason::kLowScore:
      return "low score";
    case ClosureReason::kContradicted:
      return "contradicted";
    case ClosureReason::kAmbiguous:
      return "ambiguous";
    case ClosureReason::kOpenDirection:
      return "open direction";
  }
  return "unknown";
}

ClosureVerdict closure_verdict(const SubmapMatch& match,
                               double reference_heading_rad,
                               const ClosureVerdictParams& params) {
  if (match.best.score < params.min_score) return {ClosureReason::kLowScore};
  if (match.best.contradiction > params.max_contradiction) return {ClosureReason::kContradicted};
  const double second = match.runner_up ? std::max(0.0, match.runner_up->score) : 0.0;
  const bool is_rivalled =
      match.rival && match.best.agreement - match.rival->agreement < params.min_margin;
  const bool is_alone = match.best.score - second >= params.min_margin && !is_rivalled;
  const bool is_bound = match.weak.effective_points >= params.min_effective_points;
  if (is_alone && is_bound) return {ClosureReason::kStandsAlone};

  const double all_points = match.best.hessian.topLeftCorner<2, 2>().trace();
  const bool is_corridor = match.weak.effective_points < params.max_weak_share * all_points;
  const bool others_are_along = (!match.runner_up || is_along(*match.runner_up, match, params)) &&
                                (!is_rivalled || is_along(*match.rival, match, params));
  if (!is_corridor || !others_are_along) {
    return {is_alone ? ClosureReason::kOpenDirection : ClosureReason::kAmbiguous};
  }
  // The open direction in the map frame: along x or along y?
  const double open_rad =
      std::atan2(match.weak.direction.y(), match.weak.direction.x()) + reference_heading_rad;
  const double askew_rad = std::abs(wrap_to_period(open_rad, 0.5 * kPi));
  if (askew_rad > params.max_askew_rad) return {ClosureReason::kOpenDirection};
  const bool is_open_along_x = std::abs(std::cos(open_rad)) > std::abs(std::sin(open_rad));
  return {ClosureReason::kOneAxis, is_open_along_x ? ClosureAxes::kY : ClosureAxes::kX};
}

}  // namespace setsquare
