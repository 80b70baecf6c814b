// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/graph/heading_fusion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/graph/simulated_headings.hpp"
#include "tests/support/seed.hpp"

namespace setsquare {
namespace {

using testing::HeadingSimulation;
using testing::make_generator;
using testing::simulate_headings;
using testing::SimulatedHeadings;

/// Absolute errors of the fused headings against the truth. The building has four headings that
/// look alike; the whole map may be turned by quarter turns, all keyframes by the same.
std::vector<double> errors_rad(const SimulatedHeadings& simulated, const FusedHeadings& fused) {
  const double off_rad = fused.heading_rad.front() - simulated.heading_rad.front();
  const double turn_rad = 0.5 * kPi * std::round(off_rad / (0.5 * kPi));
  std::vector<double> errors;
  for (std::size_t k = 0; k < fused.heading_rad.size(); ++k) {
    errors.push_back(
        std::abs(wrap_to_pi(fused.heading_rad[k] - simulated.heading_rad[k] - turn_rad)));
  }
  return errors;
}

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

TEST(HeadingFusion, ExactEvidenceGivesTheTruth) {
  auto generator = make_generator();
  const auto simulated = simulate_headings({}, generator);
  const auto errors = errors_rad(simulated, fuse_headings(simulated.evidence));
  EXPECT_LT(largest(errors), 1e-9);
}

TEST(HeadingFusion, ASteadyDriftOfManyQuarterTurnsDoesNotStay) {
  auto generator = make_generator();
  const auto simulated = simulate_headings(
      {.num_keyframes = 2000, .drift_per_step_rad = rad_from_deg(0.1)}, generator);
  EXPECT_LT(largest(errors_rad(simulated, fuse_headings(simulated.evidence))), rad_from_deg(0.9));
}

TEST(HeadingFusion, OutliersDoNoHarm) {
  auto generator = make_generator();
  HeadingSimulation simulation{.num_keyframes = 1000,
                               .step_noise_rad = rad_from_deg(0.08),
                               .measurement_noise_rad = rad_from_deg(0.3)};
  const auto clean = simulate_headings(simulation, generator);
  simulation.outlier_share = 0.11;  // As many as an office building was seen to have.
  const auto soiled = simulate_headings(simulation, generator);
  const double clean_rad = mean(errors_rad(clean, fuse_headings(clean.evidence)));
  const double soiled_rad = mean(errors_rad(soiled, fuse_headings(soiled.evidence)));
  EXPECT_LT(clean_rad, rad_from_deg(0.2)) << "better than the measurements' 0.24 deg";
  EXPECT_LT(soiled_rad, 1.25 * clean_rad);
}

TEST(HeadingFusion, OutliersLoseTheirWeightAndTheRestKeepTheirs) {
  auto generator = make_generator();
  auto simulated = simulate_headings({.num_keyframes = 100}, generator);
  simulated.evidence[40].proposals[0].heading_rad += rad_from_deg(20.0);
  simulated.evidence[41].proposals.clear();
  const FusedHeadings fused = fuse_headings(simulated.evidence);
  EXPECT_LT(fused.weight[40], 0.05);
  EXPECT_EQ(fused.weight[41], 0.0);
  EXPECT_GT(fused.weight[42], 0.99);
}

TEST(HeadingFusion, AShiftOfAllMeasurementsTurnsTheMapAndNothingElse) {
  auto generator = make_generator();
  const auto simulated = simulate_headings({.step_noise_rad = rad_from_deg(0.08),
                                            .measurement_noise_rad = rad_from_deg(0.3),
                                            .outlier_share = 0.1},
                                           generator);
  auto shifted = simulated;
  constexpr double kShift_rad = rad_from_deg(5.0);  // Ten bins of the trace.
  for (HeadingEvidence& evidence : shifted.evidence) {
    evidence.proposals.front().heading_rad += kShift_rad;
  }
  const FusedHeadings before = fuse_headings(simulated.evidence);
  const FusedHeadings after = fuse_headings(shifted.evidence);
  for (std::size_t k = 0; k < before.heading_rad.size(); ++k) {
    EXPECT_NEAR(
        wrap_to_period(after.heading_rad[k] - before.heading_rad[k] - kShift_rad, 0.5 * kPi),
        0.0,
        1e-9);
  }
}

TEST(HeadingFusion, WithoutWallsTheTrackedHeadingsStay) {
  std::vector<HeadingEvidence> evidence;
  for (const double heading_rad : {0.1, 0.4, -2.0}) {
    evidence.push_back(
        {.tracked_heading_rad = heading_rad, .step_sigma_rad = 0.01, .proposals = {}});
  }
  const FusedHeadings fused = fuse_headings(evidence);
  for (std::size_t k = 0; k < evidence.size(); ++k) {
    EXPECT_EQ(fused.heading_rad[k], evidence[k].tracked_heading_rad);
  }
  EXPECT_TRUE(fuse_headings({}).heading_rad.empty());
}

}  // namespace
}  // namespace setsquare
