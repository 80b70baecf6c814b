// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/candidate.hpp"

#include <cmath>

namespace setsquare {

double score(const Evidence& evidence, const ScoreParams& params) {
  if (!(evidence.wall_m > 0.0)) return 0.0;
  return (evidence.agreeing_m - params.contradiction_weight * evidence.contradicted_m -
          params.hidden_weight * evidence.hidden_m) /
         evidence.wall_m;
}

bool are_same(const Pose2& a, const Pose2& b, const AnswerParams& params) {
  const double dx_m = a.x_m - b.x_m;
  const double dy_m = a.y_m - b.y_m;
  return dx_m * dx_m + dy_m * dy_m < params.same_translation_m * params.same_translation_m &&
         std::abs(wrap_to_pi(a.theta_rad - b.theta_rad)) < params.same_rotation_rad;
}

}  // namespace setsquare
