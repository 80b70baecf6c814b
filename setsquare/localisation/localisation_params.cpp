// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/localisation/localisation_params.hpp"

#include <algorithm>
#include <cmath>

#include "setsquare/core/parameter_checks.hpp"

namespace setsquare {
namespace {

void require_share(double value, const char* name) {
  if (!(value >= 0.0 && value <= 1.0)) throw ParameterError(name, "must be from 0 to 1");
}

}  // namespace

PlaceSearchParams PlaceSearchParams::in_area(double free_m2) const {
  constexpr double kSmall_m2 = 200.0;
  constexpr double kLarge_m2 = 300.0;
  constexpr double kLeastShare = 0.2;
  const double size = (free_m2 - kSmall_m2) / (kLarge_m2 - kSmall_m2);
  const double share = kLeastShare + (1.0 - kLeastShare) * std::clamp(size, 0.0, 1.0);
  const auto part = [share](std::size_t number) {
    return static_cast<std::size_t>(std::ceil(share * static_cast<double>(number)));
  };
  PlaceSearchParams params = *this;
  params.num_proposals = part(num_proposals);
  params.num_compared = part(num_compared);
  params.num_verified = part(num_verified);
  return params;
}

void PlaceSearchParams::validate(const std::string& owner) const {
  require_at_least_one(num_rotations, owner + ".num_rotations");
  require_at_least_one(num_proposals, owner + ".num_proposals");
  require_at_least_one(num_compared, owner + ".num_compared");
  require_at_least_one(num_verified, owner + ".num_verified");
}

void LocalisationParams::validate() const {
  search.validate("search");
  search_again.validate("search_again");
  require_share(min_probability, "min_probability");
  require_share(min_probability_at_once, "min_probability_at_once");
  require_share(min_probability_by_views, "min_probability_by_views");
  require_share(min_in_map, "min_in_map");
  require_not_negative(evidence_m, "evidence_m");
  require_not_negative(evidence_rad, "evidence_rad");
  require_not_negative(fix_m, "fix_m");
  require_not_negative(fix_rad, "fix_rad");
  require_share(evidence_weight, "evidence_weight");
  require_not_negative(settled_m, "settled_m");
  require_positive(max_log_odds, "max_log_odds");
  require_positive(max_unconfirmed_m, "max_unconfirmed_m");
}

}  // namespace setsquare
