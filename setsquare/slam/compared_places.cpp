// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/slam/compared_places.hpp"

#include "setsquare/matching/match_information.hpp"

namespace setsquare {

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
    const Eigen::Vector2d& open = match.weak.direction;
    places.information = without_direction(places.information, {open.x(), open.y(), 0.0});
  }
  return places;
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
