// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/tally.hpp"

#include <algorithm>
#include <limits>

#include "setsquare/core/median.hpp"

namespace setsquare::experiments {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void Spread::add(double value) {
  ++count;
  sum += value;
  sum_of_squares += value * value;
  highest = std::max(highest, value);
}

double Spread::mean() const { return count == 0 ? kNaN : sum / static_cast<double>(count); }

double Spread::sigma() const {
  if (count == 0) return kNaN;
  const double variance = sum_of_squares / static_cast<double>(count) - mean() * mean();
  return std::sqrt(std::max(variance, 0.0));
}

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? kNaN : static_cast<double>(part) / static_cast<double>(whole);
}

double median(const std::vector<double>& values) {
  return values.empty() ? kNaN : setsquare::median(values);
}

void Tally::add(const PairAnswer& answer) {
  ++num_pairs;
  num_matched += answer.is_matched();
  num_wrong += answer.is_wrong();
  if (answer.is_success()) {
    ++num_success;
    num_matched_success += answer.is_matched();
    success_error_m.add(answer.error_m());
    success_error_rad.add(answer.error_rad());
  }
  if (answer.nees) {
    nees.add(*answer.nees);
    num_nees_inside += *answer.nees < kNees95;
    if (answer.is_wrong()) return;
    right_nees.add(*answer.nees);
    num_right_nees_inside += *answer.nees < kNees95;
  }
}

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

}  // namespace setsquare::experiments
