// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/matching/match_params.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <string>

#include "setsquare/core/error.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare::match_params_test {

struct BadField {
  const char* name;
  std::function<void(MatchParams&, double)> set;
  double value;
};

void PrintTo(const BadField& bad, std::ostream* out) { *out << bad.name << " = " << bad.value; }

class BadMatchParams : public ::testing::TestWithParam<BadField> {};

TEST_P(BadMatchParams, AreNamed) {
  MatchParams params;
  GetParam().set(params, GetParam().value);
  const Scan scan = testing::scan_of_walls(testing::l_shaped_room(), {2, 2, 0});
  try {
    (void)match(scan, scan, params);
    FAIL() << "was accepted";
  } catch (const ParameterError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr(GetParam().name));
  }
}

const double kNaN = std::nan("");
std::size_t number(double value) { return static_cast<std::size_t>(value); }

INSTANTIATE_TEST_SUITE_P(
    Fields,
    BadMatchParams,
    ::testing::Values(
        BadField{"bounds.max_translation_m",
                 [](auto& p, double v) { p.bounds.max_translation_m = v; },
                 kNaN},
        BadField{"bounds.max_rotation_rad",
                 [](auto& p, double v) { p.bounds.max_rotation_rad = v; },
                 -0.1},
        BadField{"max_range_m", [](auto& p, double v) { p.surface.max_range_m = v; }, 0.0},
        BadField{"max_weight_m", [](auto& p, double v) { p.surface.max_weight_m = v; }, kNaN},
        BadField{"tolerance_m", [](auto& p, double v) { p.score.tolerance_m = v; }, 0.0},
        BadField{"contradiction_weight",
                 [](auto& p, double v) { p.score.contradiction_weight = v; },
                 -1.0},
        BadField{
            "usual_contradiction", [](auto& p, double v) { p.score.usual_contradiction = v; }, 0.0},
        BadField{"usual_contradiction",
                 [](auto& p, double v) { p.score.usual_contradiction = v; },
                 kNaN},
        BadField{"outside_discount", [](auto& p, double v) { p.score.outside_discount = v; }, 1.0},
        BadField{"outside_discount", [](auto& p, double v) { p.score.outside_discount = v; }, -0.1},
        BadField{"outside_discount", [](auto& p, double v) { p.score.outside_discount = v; }, kNaN},
        BadField{"min_turning_m3", [](auto& p, double v) { p.answer.min_turning_m3 = v; }, -1.0},
        BadField{"min_turning_m3", [](auto& p, double v) { p.answer.min_turning_m3 = v; }, kNaN},
        BadField{"min_probability", [](auto& p, double v) { p.answer.min_probability = v; }, 0.0},
        BadField{"min_probability", [](auto& p, double v) { p.answer.min_probability = v; }, kNaN},
        BadField{"min_probability_by_rules",
                 [](auto& p, double v) { p.answer.min_probability_by_rules = v; },
                 0.9995},
        BadField{"alias.min_share", [](auto& p, double v) { p.alias.min_share = v; }, 0.0},
        BadField{"alias.max_contradiction_m",
                 [](auto& p, double v) { p.alias.max_contradiction_m = v; },
                 -0.1},
        BadField{
            "alias.min_constraint_m", [](auto& p, double v) { p.alias.min_constraint_m = v; }, 0.0},
        BadField{"alias.tolerance_m", [](auto& p, double v) { p.alias.tolerance_m = v; }, kNaN},
        BadField{"floor_score", [](auto& p, double v) { p.answer.floor_score = v; }, kNaN},
        BadField{"min_distinct_m", [](auto& p, double v) { p.answer.min_distinct_m = v; }, -0.1},
        BadField{"min_distinct_m", [](auto& p, double v) { p.answer.min_distinct_m = v; }, kNaN},
        BadField{"margin_per_contradiction",
                 [](auto& p, double v) { p.answer.margin_per_contradiction = v; },
                 -0.1},
        BadField{"rival_agreement", [](auto& p, double v) { p.answer.rival_agreement = v; }, 0.0},
        BadField{"clear_distinct_m", [](auto& p, double v) { p.answer.clear_distinct_m = v; }, 1.0},
        BadField{"rival_contradiction_m",
                 [](auto& p, double v) { p.answer.rival_contradiction_m = v; },
                 -0.1},
        BadField{"rival_contradiction",
                 [](auto& p, double v) { p.answer.rival_contradiction = v; },
                 -0.1},
        BadField{"min_score_alone", [](auto& p, double v) { p.answer.min_score_alone = v; }, kNaN},
        BadField{
            "min_margin_alone", [](auto& p, double v) { p.answer.min_margin_alone = v; }, -0.1},
        BadField{"min_wall_m", [](auto& p, double v) { p.answer.min_wall_m = v; }, -0.1},
        BadField{"hidden_weight", [](auto& p, double v) { p.score.hidden_weight = v; }, kNaN},
        BadField{
            "sure_probability", [](auto& p, double v) { p.answer.sure_probability = v; }, -0.1},
        BadField{
            "min_place_log_odds", [](auto& p, double v) { p.answer.min_place_log_odds = v; }, kNaN},
        BadField{"min_margin", [](auto& p, double v) { p.answer.min_margin = v; }, -0.1},
        BadField{"min_margin", [](auto& p, double v) { p.answer.min_margin = v; }, kNaN},
        BadField{"min_score", [](auto& p, double v) { p.answer.min_score = v; }, kNaN},
        BadField{"min_agreement", [](auto& p, double v) { p.answer.min_agreement = v; }, kNaN},
        BadField{
            "min_constraint_m", [](auto& p, double v) { p.answer.min_constraint_m = v; }, -1.0},
        BadField{
            "same_translation_m", [](auto& p, double v) { p.answer.same_translation_m = v; }, 0.0},
        BadField{
            "same_rotation_rad", [](auto& p, double v) { p.answer.same_rotation_rad = v; }, kNaN},
        BadField{
            "num_rotations", [](auto& p, double v) { p.quick.num_rotations = number(v); }, 0.0},
        BadField{"num_fine", [](auto& p, double v) { p.thorough.num_fine = number(v); }, 0.0},
        BadField{"num_coarse", [](auto& p, double v) { p.quick.num_coarse = number(v); }, 1.0},
        BadField{"min_correlation", [](auto& p, double) { p.quick.min_correlation = 0; }, 0.0},
        BadField{"max_coarse", [](auto& p, double v) { p.samples.max_coarse = number(v); }, 61.0},
        BadField{"max_coarse", [](auto& p, double v) { p.samples.max_coarse = number(v); }, 0.0},
        BadField{"max_fine", [](auto& p, double v) { p.samples.max_fine = number(v); }, 0.0},
        BadField{"max_dense", [](auto& p, double v) { p.samples.max_dense = number(v); }, 0.0},
        BadField{"coarse_tolerances_m",
                 [](auto& p, double v) { p.refinement.coarse_tolerances_m[1] = v; },
                 0.0},
        BadField{"fine_tolerances_m",
                 [](auto& p, double v) { p.refinement.fine_tolerances_m[0] = v; },
                 kNaN},
        BadField{"final_tolerances_m",
                 [](auto& p, double v) { p.refinement.final_tolerances_m[2] = v; },
                 -0.1},
        BadField{"sweep_tolerance_m",
                 [](auto& p, double v) { p.refinement.sweep_tolerance_m = v; },
                 0.0},
        BadField{"num_steps", [](auto& p, double) { p.sweep.num_steps = 0; }, 0.0},
        BadField{"piece_length_m", [](auto& p, double v) { p.sweep.piece_length_m = v; }, 0.0},
        BadField{"unevenness_m", [](auto& p, double v) { p.sweep.unevenness_m = v; }, -1.0},
        BadField{"turn_sigma", [](auto& p, double v) { p.sweep.turn_sigma = v; }, 0.0},
        BadField{"wall_variance_m3", [](auto& p, double v) { p.sweep.wall_variance_m3 = v; }, 0.0},
        BadField{
            "max_distance_m", [](auto& p, double v) { p.distinct_wall.max_distance_m = v; }, 0.0},
        BadField{"same_line_cosine",
                 [](auto& p, double v) { p.distinct_wall.same_line_cosine = v; },
                 kNaN},
        BadField{"same_line_m", [](auto& p, double v) { p.distinct_wall.same_line_m = v; }, 0.0},
        BadField{
            "same_clutter_m", [](auto& p, double v) { p.distinct_wall.same_clutter_m = v; }, 0.0},
        BadField{"max_line_m", [](auto& p, double v) { p.distinct_wall.max_line_m = v; }, 0.0}));

TEST(MatchParams, DefaultsAreValid) { EXPECT_NO_THROW(MatchParams{}.validate()); }

TEST(Match, NamesTheScanGeometryThatIsNone) {
  const Scan good = testing::scan_of_walls(testing::l_shaped_room(), {2, 2, 0});
  Scan bad = good;
  bad.bearing_step_rad = 0.0;
  EXPECT_THROW((void)match(good, bad), ParameterError);
  EXPECT_THROW((void)match(bad, good), ParameterError);
}

}  // namespace setsquare::match_params_test
