// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/scan_tracker_params.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "setsquare/core/error.hpp"

namespace setsquare::scan_tracker_params_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct BadField {
  std::string name;
  std::function<void(ScanTrackerParams&)> spoil;
};

std::vector<BadField> bad_fields() {
  using P = ScanTrackerParams;
  return {
      {"num_keyframes", [](P& p) { p.num_keyframes = 0; }},
      {"min_points", [](P& p) { p.min_points = 0; }},
      {"lost_below_score", [](P& p) { p.lost_below_score = kNan; }},
      {"image.no_return_free_m", [](P& p) { p.image.no_return_free_m = -1.0; }},
      {"image.free_margin_m", [](P& p) { p.image.free_margin_m = kNan; }},
      {"image.free_margin_ratio", [](P& p) { p.image.free_margin_ratio = -0.1; }},
      {"refinement.max_iterations", [](P& p) { p.refinement.max_iterations = 0; }},
      {"refinement.max_iterations", [](P& p) { p.refinement.max_iterations = -3; }},
      {"corridor.half_range_m", [](P& p) { p.corridor.half_range_m = 0.0; }},
      {"corridor.half_range_m", [](P& p) { p.corridor.half_range_m = kNan; }},
      {"corridor.half_range_m", [](P& p) { p.corridor.half_range_m = kInfinity; }},
      {"corridor.half_range_m", [](P& p) { p.corridor.step_m = 1e-12; }},
      {"max_lost_scans", [](P& p) { p.max_lost_scans = 0; }},
      {"long_steps.long_m", [](P& p) { p.long_steps.long_m = 0.0; }},
      {"long_steps.long_rad", [](P& p) { p.long_steps.long_rad = kNan; }},
      {"long_steps.num_steps", [](P& p) { p.long_steps.num_steps = 0; }},
      {"long_steps.min_long", [](P& p) { p.long_steps.min_long = 0; }},
      {"long_steps.least_reach_m", [](P& p) { p.long_steps.least_reach_m = -1.0; }},
      {"long_steps.least_reach_rad", [](P& p) { p.long_steps.least_reach_rad = 0.0; }},
      {"long_steps.reach_per_step", [](P& p) { p.long_steps.reach_per_step = kInfinity; }},
      {"votes.num_keyframes", [](P& p) { p.votes.num_keyframes = 0; }},
      {"votes.same_m", [](P& p) { p.votes.same_m = 0.0; }},
      {"votes.same_rad", [](P& p) { p.votes.same_rad = kNan; }},
      {"votes.min_votes_for_jump", [](P& p) { p.votes.min_votes_for_jump = -1.0; }},
      {"votes.min_probability", [](P& p) { p.votes.min_probability = kNan; }},
      {"votes.least_open_sigma_m", [](P& p) { p.votes.least_open_sigma_m = 0.0; }},
      {"step_odds.decades_per_reach", [](P& p) { p.votes.odds.decades_per_reach = -1.0; }},
      {"step_odds.least_wrong", [](P& p) { p.votes.odds.least_wrong = 0.0; }},
      {"step_odds.least_wrong", [](P& p) { p.votes.odds.least_wrong = 0.5; }},
      {"refinement.turn.noise_rad", [](P& p) { p.refinement.turn.noise_rad = -0.1; }},
      {"refinement.turn.bound_rad", [](P& p) { p.refinement.turn.bound_rad = 0.0; }},
      {"odometry.stretch_m", [](P& p) { p.odometry.stretch_m = 0.0; }},
      {"odometry.min_score", [](P& p) { p.odometry.min_score = kNan; }},
      {"odometry.min_stretches", [](P& p) { p.odometry.min_stretches = 0; }},
      {"odometry.max_deviation", [](P& p) { p.odometry.max_deviation = kInfinity; }},
      {"odometry.usual_scale", [](P& p) { p.odometry.usual_scale = 1.0; }},
      {"odometry.wheels_at_rest_m", [](P& p) { p.odometry.wheels_at_rest_m = -1.0; }},
      {"recovery.num_keyframes", [](P& p) { p.recovery.num_keyframes = 0; }},
      {"recovery.below_score", [](P& p) { p.recovery.below_score = kNan; }},
      {"recovery.below_score_if_open", [](P& p) { p.recovery.below_score_if_open = kNan; }},
      {"recovery.enough_score", [](P& p) { p.recovery.enough_score = kNan; }},
      {"recovery.far_min_score", [](P& p) { p.recovery.far_min_score = kInfinity; }},
      {"recovery.min_gain", [](P& p) { p.recovery.min_gain = -0.1; }},
      {"recovery.near_m", [](P& p) { p.recovery.near_m = 0.0; }},
      {"recovery.near_rad", [](P& p) { p.recovery.near_rad = kNan; }},
  };
}

TEST(ScanTrackerParams, TheDefaultsAreValid) { EXPECT_NO_THROW(ScanTrackerParams{}.validate()); }

TEST(ScanTrackerParams, ABadFieldIsNamed) {
  for (const BadField& field : bad_fields()) {
    ScanTrackerParams params;
    field.spoil(params);
    try {
      params.validate();
      ADD_FAILURE() << field.name << " passed";
    } catch (const ParameterError& error) {
      EXPECT_NE(std::string(error.what()).find(field.name), std::string::npos) << error.what();
    }
  }
}

}  // namespace setsquare::scan_tracker_params_test
