// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/loops/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "setsquare/core/parameter_checks.hpp"
#include "setsquare/matching/information.hpp"

namespace setsquare {
namespace {

/// Angle between a direction and an offset, modulo pi: 0 to pi / 2.
double angle_between(const Eigen::Vector2d& direction, const Eigen::Vector2d& offset_m) {
  const double along = std::abs(direction.dot(offset_m));
  const double across = std::abs(direction.x() * offset_m.y() - direction.y() * offset_m.x());
  return std::atan2(across, along);
}

/// The other poses that explain the submaps almost as well as the best.
std::vector<SubmapFitBothWays> rivals_of(const SubmapMatch& match,
                                         const ClosureVerdictParams& params) {
  std::vector<SubmapFitBothWays> rivals;
  for (const SubmapFitBothWays& other : match.others) {
    if (match.best.score - other.score < params.min_margin ||
        match.best.agreement - other.agreement < params.min_margin) {
      rivals.push_back(other);
    }
  }
  return rivals;
}

/// Whether another pose lies along the open direction from the best.
bool is_along(const SubmapFitBothWays& other,
              const SubmapMatch& match,
              const ClosureVerdictParams& params) {
  const Eigen::Vector2d offset_m =
      other.T_reference_current.translation() - match.best.T_reference_current.translation();
  return angle_between(match.open.direction, offset_m) < params.max_rival_rad;
}

}  // namespace

void ClosureVerdictParams::validate() const {
  require_positive(min_score, "verdict.min_score");
  require_not_negative(max_contradiction, "verdict.max_contradiction");
  require_not_negative(min_margin, "verdict.min_margin");
  require_positive(min_effective_points, "verdict.min_effective_points");
  require_not_negative(max_open_share, "verdict.max_open_share");
  require_not_negative(max_rival_rad, "verdict.max_rival_rad");
  require_not_negative(max_askew_rad, "verdict.max_askew_rad");
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

ClosureAxes axis_across(double open_rad) {
  const bool is_along_x = std::abs(std::cos(open_rad)) > std::abs(std::sin(open_rad));
  return is_along_x ? ClosureAxes::kY : ClosureAxes::kX;
}

ClosureVerdict closure_verdict(const SubmapMatch& match,
                               double reference_heading_rad,
                               const ClosureVerdictParams& params) {
  if (match.best.score < params.min_score) return {ClosureReason::kLowScore};
  if (match.best.contradiction > params.max_contradiction) return {ClosureReason::kContradicted};
  const std::vector<SubmapFitBothWays> rivals = rivals_of(match, params);
  const bool is_bound = match.open.effective_points >= params.min_effective_points;
  if (rivals.empty() && is_bound) return {ClosureReason::kStandsAlone};

  const double all_points = match.best.hessian.topLeftCorner<2, 2>().trace();
  const bool is_corridor = match.open.effective_points < params.max_open_share * all_points;
  const bool are_along = std::all_of(rivals.begin(), rivals.end(), [&](const auto& rival) {
    return is_along(rival, match, params);
  });
  if (!is_corridor || !are_along) {
    return {rivals.empty() ? ClosureReason::kOpenDirection : ClosureReason::kAmbiguous};
  }
  const double open_rad =
      std::atan2(match.open.direction.y(), match.open.direction.x()) + reference_heading_rad;
  const double askew_rad = std::abs(wrap_to_period(open_rad, 0.5 * kPi));
  if (askew_rad > params.max_askew_rad) return {ClosureReason::kOpenDirection};
  return {ClosureReason::kOneAxis, axis_across(open_rad)};
}

ComparedPlaces judged_places(std::size_t from,
                             std::size_t to,
                             const SubmapMatch& match,
                             double from_heading_rad,
                             double point_sigma_m,
                             const ClosureVerdictParams& params) {
  ComparedPlaces places;
  places.from = from;
  places.to = to;
  places.T_from_to = match.best.T_reference_current;
  places.verdict = closure_verdict(match, from_heading_rad, params);
  places.score = match.best.score;
  places.contradiction = match.best.contradiction;
  places.information = match.best.hessian / (point_sigma_m * point_sigma_m);
  if (places.verdict.reason == ClosureReason::kOneAxis) {
    const Eigen::Vector2d& open = match.open.direction;
    places.information = without_direction(places.information, {open.x(), open.y(), 0.0});
  }
  return places;
}

ComparedPlaces matched_places(std::size_t from,
                              std::size_t to,
                              const Pose2& T_from_to,
                              const Eigen::Matrix3d& information) {
  return {.from = from,
          .to = to,
          .T_from_to = T_from_to,
          .information = information,
          .verdict = {ClosureReason::kStandsAlone, ClosureAxes::kXY},
          .score = 0.0,
          .contradiction = 0.0};
}

Constraint closure_constraint(const ComparedPlaces& places) {
  return {.from = places.from,
          .to = places.to,
          .T_from_to = places.T_from_to,
          .information = places.information,
          .kind = ConstraintKind::kLoopClosure,
          .weight = 1.0};
}

}  // namespace setsquare
