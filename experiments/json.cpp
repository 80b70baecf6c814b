// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/json.hpp"

namespace setsquare::experiments {

Json json_from(const Spread& spread, double unit) {
  if (spread.count == 0) return nullptr;
  return {{"count", spread.count},
          {"mean", unit * spread.mean()},
          {"sigma", unit * spread.sigma()},
          {"max", unit * spread.highest}};
}

Json json_from(const Tally& tally) {
  return {{"num_pairs", tally.num_pairs},
          {"num_success", tally.num_success},
          {"success_share", tally.success_share()},
          {"num_matched", tally.num_matched},
          {"matched_share", tally.matched_share()},
          {"num_matched_success", tally.num_matched_success},
          {"num_wrong", tally.num_wrong},
          {"wrong_share_of_matched", tally.wrong_share()},
          {"success_error_m", json_from(tally.success_error_m)},
          {"success_error_deg", json_from(tally.success_error_rad, deg_from_rad(1.0))},
          {"nees", json_from(tally.nees)},
          {"nees_below_7_81_share", tally.nees_inside_share()},
          {"nees_of_right", json_from(tally.right_nees)},
          {"nees_of_right_below_7_81_share", tally.right_nees_inside_share()}};
}

Json json_from(const PairAnswer& answer) {
  Json json = {{"status", to_string(answer.status)},
               {"error_m", answer.error_m()},
               {"error_deg", deg_from_rad(answer.error_rad())}};
  if (answer.nees) json["nees"] = *answer.nees;
  return json;
}

Json json_from(const Pose2& pose) {
  return {{"x_m", pose.x_m}, {"y_m", pose.y_m}, {"heading_deg", deg_from_rad(pose.theta_rad)}};
}

}  // namespace setsquare::experiments
