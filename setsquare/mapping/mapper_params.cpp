// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/mapper_params.hpp"

#include "setsquare/core/parameter_checks.hpp"

namespace setsquare {

void ForgettingParams::validate() const {
  require_at_least_one(min_visits, "forgetting.min_visits");
  require_positive(near_m, "forgetting.near_m");
  require_not_negative(near_rad, "forgetting.near_rad");
  require_positive(visit_way_m, "forgetting.visit_way_m");
  scale.validate("forgetting.scale");
  require_not_negative(min_explained, "forgetting.min_explained");
  require_not_negative(max_contradicted, "forgetting.max_contradicted");
  require_not_negative(min_effective_points, "forgetting.min_effective_points");
  require_not_negative(max_off_m, "forgetting.max_off_m");
  require_not_negative(max_off_rad, "forgetting.max_off_rad");
  require_at_least_one(shortest_run, "forgetting.shortest_run");
  require_positive(known_sigma_m, "forgetting.known_sigma_m");
  require_positive(known_sigma_rad, "forgetting.known_sigma_rad");
}

void PieceJoiningParams::validate() const {
  require_at_least_one(max_num_queries, "joining.max_num_queries");
  require_at_least_one(num_similar, "joining.num_similar");
  require_positive(window_m, "joining.window_m");
  require_at_least_one(min_agreeing, "joining.min_agreeing");
  require_at_least_one(num_across_lost, "joining.num_across_lost");
  require_positive(min_votes_across_break, "joining.min_votes_across_break");
  require_finite(min_log_odds_across_break, "joining.min_log_odds_across_break");
  steps.validate();
  odds.validate();
  require_positive(joint_open_sigma_m, "joining.joint_open_sigma_m");
  require_positive(joint_sigma_m, "joining.joint_sigma_m");
  require_positive(joint_sigma_rad, "joining.joint_sigma_rad");
  require_positive(agreeing_m, "joining.agreeing_m");
  require_positive(agreeing_rad, "joining.agreeing_rad");
  require_not_negative(min_extent_m, "joining.min_extent_m");
  require_not_negative(max_seen_through, "joining.max_seen_through");
}

void MapperParams::validate() const {
  tracker.validate();
  mounting.validate();
  direction.validate();
  motion.validate();
  heading.validate();
  turns.validate();
  closing.validate();
  outvoted.validate();
  robust.validate();
  forgetting.validate();
  joining.validate();
  registration.validate();
  heading_spread.validate();
  anywhere.validate();
  audit.validate();
  if (!(confident_margin > 1.0)) throw ParameterError("confident_margin", "must be above 1");
  require_not_negative(closing_growth, "closing_growth");
  require_at_least_one(min_closing_growth, "min_closing_growth");
}

}  // namespace setsquare
