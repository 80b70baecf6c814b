// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/candidate.hpp"

#include <cmath>

namespace setsquare {

double score(const Evidence& evidence, const ScoreParams& params) {
  const double compared_m = evidence.wall_m - params.outside_discount * evidence.outside_m;
  if (!(compared_m > 0.0)) return 0.0;
  const double contradiction = evidence.contradicted_m / compared_m;
  return (evidence.agreeing_m - params.hidden_weight * evidence.hidden_m) / compared_m -
         params.contradiction_weight * std::log1p(contradiction / params.usual_contradiction);
}

bool are_same(const Pose2& a, const Pose2& b, const AnswerParams& params) {
  const double dx_m = a.x_m - b.x_m;
  const double dy_m = a.y_m - b.y_m;
  return dx_m * dx_m + dy_m * dy_m < params.same_translation_m * params.same_translation_m &&
         std::abs(wrap_to_pi(a.theta_rad - b.theta_rad)) < params.same_rotation_rad;
}

}  // namespace setsquare
