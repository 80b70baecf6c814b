// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "benchmarks/peers/comparison.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

namespace setsquare::peers {
namespace {

struct Tolerance {
  double translation_m;
  double rotation_rad;
};
constexpr Tolerance kSuccess = {0.2, rad_from_deg(30.0)};
constexpr Tolerance kTight = {0.05, rad_from_deg(1.0)};

bool is_within(const Pose2& error, const Tolerance& tolerance) {
  return std::hypot(error.x_m, error.y_m) <= tolerance.translation_m &&
         std::abs(error.theta_rad) <= tolerance.rotation_rad;
}

/// What is left between the true and the found pose of the robot, in the frame of the true one.
Pose2 error_of(const Pose2& T_sensor_sensor, const ScanPair& pair) {
  const Pose2 T_reference_current =
      pair.reference.T_base_sensor * T_sensor_sensor * pair.current.T_base_sensor.inverse();
  return pair.T_reference_current.inverse() * T_reference_current;
}

double median_time_ms(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  return upper_median(std::move(values));
}

struct Tally {
  int num_success = 0;
  int num_tight = 0;
  std::vector<double> times_ms;
};

void try_pair(const Matcher& matcher, const ScanPair& pair, Tally& tally) {
  const auto begin = std::chrono::steady_clock::now();
  const std::optional<Pose2> T_sensor_sensor = matcher.match(pair.reference, pair.current);
  const std::chrono::duration<double, std::milli> elapsed =
      std::chrono::steady_clock::now() - begin;
  tally.times_ms.push_back(elapsed.count());
  if (!T_sensor_sensor) return;
  const Pose2 error = error_of(*T_sensor_sensor, pair);
  tally.num_success += is_within(error, kSuccess) ? 1 : 0;
  tally.num_tight += is_within(error, kTight) ? 1 : 0;
}

}  // namespace

std::vector<MatcherScore> compare(const std::vector<Matcher>& matchers,
                                  const std::vector<ScanPair>& pairs) {
  std::vector<Tally> tallies(matchers.size());
  for (const ScanPair& pair : pairs) {
    for (std::size_t m = 0; m < matchers.size(); ++m) {
      try_pair(matchers[m], pair, tallies[m]);
    }
  }
  const double num_pairs = std::max(1.0, static_cast<double>(pairs.size()));
  std::vector<MatcherScore> scores;
  for (std::size_t m = 0; m < matchers.size(); ++m) {
    scores.push_back({.name = matchers[m].name,
                      .success = tallies[m].num_success / num_pairs,
                      .tight = tallies[m].num_tight / num_pairs,
                      .median_ms = median_time_ms(std::move(tallies[m].times_ms))});
  }
  return scores;
}

}  // namespace setsquare::peers
