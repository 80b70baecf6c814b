// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/headings/trace.hpp"
#include "tests/headings/simulated_headings.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::heading_trace_test {

using testing::HeadingSimulation;
using testing::make_generator;
using testing::simulate_headings;
using testing::SimulatedHeadings;
using testing::uniform;

/// Largest distance of the traced drift from the true one, modulo a quarter turn.
double worst_miss_rad(const SimulatedHeadings& simulated, const HeadingTrace& trace) {
  double worst_rad = 0.0;
  for (std::size_t k = 0; k < trace.offset_rad.size(); ++k) {
    const double heading_rad = simulated.evidence[k].tracked_heading_rad + trace.offset_rad[k];
    const double miss_rad = wrap_to_period(heading_rad - simulated.heading_rad[k], 0.5 * kPi);
    worst_rad = std::max(worst_rad, std::abs(miss_rad));
  }
  return worst_rad;
}

std::size_t num_changes(const HeadingTrace& trace) {
  return static_cast<std::size_t>(std::count(trace.is_change.begin(), trace.is_change.end(), true));
}

/// What a path through the offsets costs, added up term by term.
double path_cost(const std::vector<HeadingEvidence>& keyframes,
                 const std::vector<double>& offset_rad,
                 const HeadingTraceParams& params) {
  double cost = 0.0;
  for (std::size_t k = 0; k < keyframes.size(); ++k) {
    cost += passing_cost(keyframes[k], offset_rad[k], params);
    if (k == 0) continue;
    const double move_rad =
        std::abs(wrap_to_period(offset_rad[k] - offset_rad[k - 1], params.period_rad));
    const double sigma_rad = std::max(keyframes[k].step_sigma_rad, params.min_step_sigma_rad);
    cost += std::min(params.drift_cost * move_rad / sigma_rad, params.change_cost);
  }
  return cost;
}

/// The cheapest of all paths, each one tried.
double least_path_cost(const std::vector<HeadingEvidence>& keyframes,
                       std::size_t num_bins,
                       const HeadingTraceParams& params) {
  std::vector<std::size_t> bins(keyframes.size(), 0);
  std::vector<double> offset_rad(keyframes.size());
  double least = 1e9;
  while (true) {
    for (std::size_t k = 0; k < bins.size(); ++k) {
      offset_rad[k] =
          (static_cast<double>(bins[k]) + 0.5) * params.period_rad / static_cast<double>(num_bins);
    }
    least = std::min(least, path_cost(keyframes, offset_rad, params));
    std::size_t k = 0;
    while (k < bins.size() && ++bins[k] == num_bins) bins[k++] = 0;
    if (k == bins.size()) return least;
  }
}

TEST(HeadingTrace, IsTheCheapestOfAllPaths) {
  auto generator = make_generator();
  constexpr std::size_t kNumBins = 7;
  HeadingTraceParams params;
  params.bin_rad = params.period_rad / static_cast<double>(kNumBins);
  params.inlier_rad = 0.25;
  params.change_cost = 0.8;
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<HeadingEvidence> keyframes(5);
    for (HeadingEvidence& keyframe : keyframes) {
      keyframe.tracked_heading_rad = uniform(generator, -4.0, 4.0);
      keyframe.step_sigma_rad = uniform(generator, 0.0, 1.0);
      while (uniform(generator, 0.0, 1.0) < 0.6) {
        keyframe.proposals.push_back(
            {uniform(generator, 0.0, 1.6), 0.01, uniform(generator, 0.0, 1.0)});
      }
    }
    const HeadingTrace trace = trace_headings(keyframes, params);
    EXPECT_NEAR(path_cost(keyframes, trace.offset_rad, params),
                least_path_cost(keyframes, kNumBins, params),
                1e-12)
        << "trial " << trial;
  }
}

TEST(HeadingTrace, FollowsADriftOfSeveralQuarterTurns) {
  auto generator = make_generator();
  const auto simulated = simulate_headings(
      {.num_keyframes = 1000, .drift_per_step_rad = rad_from_deg(0.25)}, generator);
  const HeadingTrace trace = trace_headings(simulated.evidence);
  EXPECT_LT(worst_miss_rad(simulated, trace), rad_from_deg(2.0));
  EXPECT_NEAR(
      trace.offset_rad.back() - trace.offset_rad.front(), rad_from_deg(250.0), rad_from_deg(4.0))
      << "unwrapped: the drift went on beyond a quarter turn (it lags at both ends)";
  EXPECT_EQ(num_changes(trace), 0U);
}

TEST(HeadingTrace, PassesOutliers) {
  auto generator = make_generator();
  const auto simulated = simulate_headings({.drift_per_step_rad = rad_from_deg(0.05),
                                            .measurement_noise_rad = rad_from_deg(0.3),
                                            .outlier_share = 0.4},
                                           generator);
  const HeadingTrace trace = trace_headings(simulated.evidence);
  EXPECT_LT(worst_miss_rad(simulated, trace), rad_from_deg(2.0));
  EXPECT_EQ(num_changes(trace), 0U);
}

TEST(HeadingTrace, ALooseRotationMayJump) {
  auto generator = make_generator();
  auto simulated = simulate_headings({.num_keyframes = 100}, generator);
  constexpr double kJump_rad = rad_from_deg(30.0);
  for (std::size_t k = 50; k < 100; ++k) simulated.evidence[k].tracked_heading_rad -= kJump_rad;
  simulated.evidence[50].step_sigma_rad = 0.5;  // The scan was lost there.
  const HeadingTrace trace = trace_headings(simulated.evidence);
  EXPECT_LT(worst_miss_rad(simulated, trace), rad_from_deg(0.6));
  EXPECT_EQ(num_changes(trace), 0U) << "drift, not another frame";
}

TEST(HeadingTrace, ALostScanExplainsNoTurnOfTheWalls) {
  auto generator = make_generator();
  auto simulated = simulate_headings(
      {.num_keyframes = 200, .wing_offset_rad = {0.0, rad_from_deg(40.0)}}, generator);
  simulated.evidence[100].step_sigma_rad = 0.05;
  const HeadingTrace trace = trace_headings(simulated.evidence);
  EXPECT_EQ(num_changes(trace), 1U);
  EXPECT_TRUE(trace.is_change[100]);
}

TEST(HeadingTrace, AFirmRotationIntoAnotherWingIsAChange) {
  auto generator = make_generator();
  const auto simulated = simulate_headings({.num_keyframes = 200,
                                            .drift_per_step_rad = rad_from_deg(0.02),
                                            .wing_offset_rad = {0.0, rad_from_deg(30.0)}},
                                           generator);
  const HeadingTrace trace = trace_headings(simulated.evidence);
  ASSERT_EQ(num_changes(trace), 1U);
  EXPECT_TRUE(trace.is_change[100]);
  EXPECT_NEAR(trace.offset_rad[100] - trace.offset_rad[99], rad_from_deg(30.0), rad_from_deg(1.2));
}

TEST(HeadingTrace, ChoosesAmongSeveralProposals) {
  auto generator = make_generator();
  auto simulated = simulate_headings({.num_keyframes = 200}, generator);
  for (std::size_t k = 0; k < 200; ++k) {
    auto& proposals = simulated.evidence[k].proposals;
    // A second peak, stronger than the right one in half of the keyframes, and never the same.
    const double wrong_rad = proposals.front().heading_rad + 0.3 + 0.02 * static_cast<double>(k);
    proposals.push_back({wrong_rad, rad_from_deg(0.1), k % 2 == 0 ? 1.0 : 0.5});
    if (k % 2 == 0) proposals.front().confidence = 0.7;
  }
  EXPECT_LT(worst_miss_rad(simulated, trace_headings(simulated.evidence)), rad_from_deg(0.6));
}

TEST(HeadingTrace, NothingInNothingOut) { EXPECT_TRUE(trace_headings({}).offset_rad.empty()); }

TEST(HeadingTrace, NamesABadParameter) {
  EXPECT_THROW(HeadingTraceParams{.bin_rad = 0.0}.validate(), ParameterError);
  EXPECT_THROW(HeadingTraceParams{.period_rad = -1.0}.validate(), ParameterError);
  EXPECT_THROW(HeadingTraceParams{.change_cost = 0.0}.validate(), ParameterError);
  EXPECT_NO_THROW(HeadingTraceParams{}.validate());
}

}  // namespace setsquare::heading_trace_test
