// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/heading_drift.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "setsquare/core/error.hpp"
#include "tests/graph/simulated_headings.hpp"
#include "tests/support/seed.hpp"

namespace setsquare {
namespace {

using testing::HeadingSimulation;
using testing::make_generator;
using testing::simulate_headings;
using testing::SimulatedHeadings;

/// Largest distance of the traced drift from the true one, modulo a quarter turn.
double worst_miss_rad(const SimulatedHeadings& simulated, const std::vector<double>& drift_rad) {
  double worst_rad = 0.0;
  for (std::size_t k = 0; k < drift_rad.size(); ++k) {
    const double heading_rad = simulated.evidence[k].tracked_heading_rad + drift_rad[k];
    const double miss_rad = wrap_to_period(heading_rad - simulated.heading_rad[k], 0.5 * kPi);
    worst_rad = std::max(worst_rad, std::abs(miss_rad));
  }
  return worst_rad;
}

TEST(HeadingDrift, FollowsADriftOfSeveralQuarterTurns) {
  auto generator = make_generator();
  const auto simulated = simulate_headings(
      {.num_keyframes = 1000, .drift_per_step_rad = rad_from_deg(0.25)}, generator);
  const std::vector<double> drift_rad = trace_heading_drift(simulated.evidence);
  EXPECT_LT(worst_miss_rad(simulated, drift_rad), rad_from_deg(1.2));
  EXPECT_NEAR(drift_rad.back() - drift_rad.front(), rad_from_deg(250.0), rad_from_deg(2.5))
      << "unwrapped: the drift went on beyond a quarter turn (it lags at both ends)";
}

TEST(HeadingDrift, PassesOutliers) {
  auto generator = make_generator();
  const auto simulated = simulate_headings({.drift_per_step_rad = rad_from_deg(0.05),
                                            .measurement_noise_rad = rad_from_deg(0.3),
                                            .outlier_share = 0.4},
                                           generator);
  EXPECT_LT(worst_miss_rad(simulated, trace_heading_drift(simulated.evidence)), rad_from_deg(2.0));
}

TEST(HeadingDrift, ALooseRotationMayJump) {
  auto generator = make_generator();
  auto simulated = simulate_headings({.num_keyframes = 100}, generator);
  constexpr double kJump_rad = rad_from_deg(30.0);
  for (std::size_t k = 50; k < 100; ++k) simulated.evidence[k].tracked_heading_rad -= kJump_rad;
  simulated.evidence[50].step_sigma_rad = 0.5;  // The scan was lost there.
  EXPECT_LT(worst_miss_rad(simulated, trace_heading_drift(simulated.evidence)), rad_from_deg(0.6));
}

TEST(HeadingDrift, ChoosesAmongSeveralProposals) {
  auto generator = make_generator();
  auto simulated = simulate_headings({.num_keyframes = 200}, generator);
  for (std::size_t k = 0; k < 200; ++k) {
    auto& proposals = simulated.evidence[k].proposals;
    // A second peak, stronger than the right one in half of the keyframes, and never the same.
    const double wrong_rad = proposals.front().heading_rad + 0.3 + 0.02 * static_cast<double>(k);
    proposals.push_back({wrong_rad, rad_from_deg(0.1), k % 2 == 0 ? 1.0 : 0.5});
    if (k % 2 == 0) proposals.front().confidence = 0.7;
  }
  EXPECT_LT(worst_miss_rad(simulated, trace_heading_drift(simulated.evidence)), rad_from_deg(0.6));
}

TEST(HeadingDrift, NothingInNothingOut) { EXPECT_TRUE(trace_heading_drift({}).empty()); }

TEST(HeadingDrift, NamesABadParameter) {
  EXPECT_THROW(HeadingDriftParams{.bin_rad = 0.0}.validate(), ParameterError);
  EXPECT_THROW(HeadingDriftParams{.period_rad = -1.0}.validate(), ParameterError);
  EXPECT_NO_THROW(HeadingDriftParams{}.validate());
}

}  // namespace
}  // namespace setsquare
