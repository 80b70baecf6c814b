// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/match_params.hpp"

#include <cmath>

#include "setsquare/core/error.hpp"

namespace setsquare {
namespace {

void require(bool holds, const char* name, const char* reason) {
  if (!holds) throw ParameterError(name, reason);
}

void validate_search(const SearchParams& search) {
  require(search.num_rotations > 0, "num_rotations", "must be positive");
  require(search.num_fine > 0, "num_fine", "must be positive");
  require(search.num_coarse >= search.num_fine, "num_coarse", "must not be below num_fine");
}

}  // namespace

void MatchParams::validate() const {
  surface.validate();
  require(score.tolerance_m > 0.0, "tolerance_m", "must be positive");
  require(score.contradiction_weight >= 0.0, "contradiction_weight", "must not be negative");
  require(score.usual_contradiction > 0.0, "usual_contradiction", "must be positive");
  require(score.outside_discount >= 0.0 && score.outside_discount < 1.0,
          "outside_discount",
          "must be in [0, 1)");
  require(score.hidden_weight >= 0.0, "hidden_weight", "must not be negative");
  require(std::isfinite(answer.min_score), "min_score", "must be finite");
  require(std::isfinite(answer.min_agreement), "min_agreement", "must be finite");
  require(answer.min_turning_m3 >= 0.0, "min_turning_m3", "must not be negative");
  require(std::isfinite(answer.floor_score), "floor_score", "must be finite");
  require(answer.min_margin >= 0.0, "min_margin", "must not be negative");
  require(std::isfinite(answer.min_score_alone), "min_score_alone", "must be finite");
  require(answer.min_wall_m >= 0.0, "min_wall_m", "must not be negative");
  require(answer.rival_agreement > 0.0, "rival_agreement", "must be positive");
  require(answer.rival_contradiction >= 0.0, "rival_contradiction", "must not be negative");
  require(
      answer.margin_per_contradiction >= 0.0, "margin_per_contradiction", "must not be negative");
  require(answer.min_distinct_m >= 0.0, "min_distinct_m", "must not be negative");
  require(answer.clear_distinct_m >= answer.min_distinct_m,
          "clear_distinct_m",
          "must not be below min_distinct_m");
  require(answer.rival_contradiction_m >= 0.0, "rival_contradiction_m", "must not be negative");
  require(answer.min_margin_alone >= 0.0, "min_margin_alone", "must not be negative");
  require(answer.min_constraint_m >= 0.0, "min_constraint_m", "must not be negative");
  require(answer.same_translation_m > 0.0, "same_translation_m", "must be positive");
  require(answer.same_rotation_rad > 0.0, "same_rotation_rad", "must be positive");
  validate_search(quick);
  validate_search(thorough);
}

}  // namespace setsquare
