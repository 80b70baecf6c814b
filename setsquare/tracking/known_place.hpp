// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "setsquare/matching/match_params.hpp"

namespace setsquare {

/// How scans that were taken moments apart are matched. They show one place, so that walls need not
/// tell it from others: no wall must be distinct, a lower probability will do (it is that of scans
/// from anywhere within metres), and a motion under which the place looks the same is no objection.
/// What speaks for the pose itself is asked all the same.
[[nodiscard]] inline MatchParams params_of_a_known_place() {
  MatchParams params;
  params.answer.min_distinct_m = 0.0;
  params.answer.clear_distinct_m = 0.0;
  params.answer.min_probability_by_rules = 0.0;
  params.alias.is_on = false;
  return params;
}

}  // namespace setsquare
