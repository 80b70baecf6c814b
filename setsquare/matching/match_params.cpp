// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/match_params.hpp"

#include <cmath>

#include "setsquare/core/error.hpp"
#include "setsquare/core/parameter_checks.hpp"

namespace setsquare {
namespace {

void require(bool holds, const char* name, const char* reason) {
  if (!holds) throw ParameterError(name, reason);
}

void validate_search(const SearchParams& search) {
  require(search.num_rotations > 0, "num_rotations", "must be positive");
  require(search.num_fine > 0, "num_fine", "must be positive");
  require(search.min_correlation > 0, "min_correlation", "must be positive");
  require(search.num_coarse >= search.num_fine, "num_coarse", "must not be below num_fine");
}

}  // namespace

void RefinementParams::validate() const {
  for (const double tolerance_m : coarse_tolerances_m) {
    require_positive(tolerance_m, "coarse_tolerances_m");
  }
  for (const double tolerance_m : fine_tolerances_m) {
    require_positive(tolerance_m, "fine_tolerances_m");
  }
  for (const double tolerance_m : final_tolerances_m) {
    require_positive(tolerance_m, "final_tolerances_m");
  }
  require_positive(sweep_tolerance_m, "sweep_tolerance_m");
}

void SweepParams::validate() const {
  require_at_least_one(num_steps, "num_steps");
  require_positive(piece_length_m, "piece_length_m");
  require_not_negative(unevenness_m, "unevenness_m");
  require_positive(turn_sigma, "turn_sigma");
  require_positive(wall_variance_m3, "wall_variance_m3");
}

void DistinctWallParams::validate() const {
  require_positive(max_distance_m, "max_distance_m");
  require_finite(same_line_cosine, "same_line_cosine");
  require_positive(same_line_m, "same_line_m");
  require_positive(same_clutter_m, "same_clutter_m");
  require_positive(max_line_m, "max_line_m");
}

void MotionBounds::validate() const {
  require(max_translation_m >= 0.0, "bounds.max_translation_m", "must not be negative");
  require(max_rotation_rad >= 0.0, "bounds.max_rotation_rad", "must not be negative");
}

void AliasParams::validate() const {
  require_positive(min_share, "alias.min_share");
  require_not_negative(max_contradiction_m, "alias.max_contradiction_m");
  require_positive(min_constraint_m, "alias.min_constraint_m");
  require_positive(tolerance_m, "alias.tolerance_m");
}

void MatchParams::validate() const {
  bounds.validate();
  surface.validate();
  samples.validate();
  refinement.validate();
  sweep.validate();
  distinct_wall.validate();
  alias.validate();
  require(score.tolerance_m > 0.0, "tolerance_m", "must be positive");
  require(score.contradiction_weight >= 0.0, "contradiction_weight", "must not be negative");
  require(score.usual_contradiction > 0.0, "usual_contradiction", "must be positive");
  require(score.outside_discount >= 0.0 && score.outside_discount < 1.0,
          "outside_discount",
          "must be in [0, 1)");
  require(score.hidden_weight >= 0.0, "hidden_weight", "must not be negative");
  require(answer.min_probability > 0.0, "min_probability", "must be positive");
  require(answer.min_probability_by_rules >= 0.0 &&
              answer.min_probability_by_rules <= answer.min_probability,
          "min_probability_by_rules",
          "must be in [0, min_probability]");
  require(answer.sure_probability >= 0.0, "sure_probability", "must not be negative");
  require(!std::isnan(answer.min_place_log_odds), "min_place_log_odds", "must be a number");
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
