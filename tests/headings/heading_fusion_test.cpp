// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "setsquare/headings/fusion.hpp"
#include "tests/headings/simulated_headings.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::heading_fusion_test {

using testing::HeadingSimulation;
using testing::make_generator;
using testing::simulate_headings;
using testing::SimulatedHeadings;

/// Absolute errors of the fused headings against the truth. The building has four headings that
/// look the same; the whole map may be turned by quarter turns, all keyframes by the same.
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

TEST(HeadingFusion, WingsAtOddAnglesKeepTheirAngles) {
  auto generator = make_generator();
  const auto simulated = simulate_headings({.num_keyframes = 1200,
                                            .drift_per_step_rad = rad_from_deg(0.02),
                                            .step_noise_rad = rad_from_deg(0.05),
                                            .measurement_noise_rad = rad_from_deg(0.3),
                                            .outlier_share = 0.2,
                                            .wing_offset_rad = {0.0, rad_from_deg(37.0)},
                                            .keyframes_per_wing = 150},
                                           generator);
  const FusedHeadings fused = fuse_headings(simulated.evidence);
  ASSERT_EQ(fused.frames.size(), 2U);
  const double offset_rad = fused.frames[1].offset_rad;
  const double expected_rad = rad_from_deg(fused.frame[10] == 0 ? 37.0 : -37.0);
  EXPECT_NEAR(offset_rad, expected_rad, 4.0 * fused.frames[1].sigma_rad);
  EXPECT_LT(fused.frames[1].sigma_rad, rad_from_deg(0.3));
  const double main_rad = fused.frame[10] == 0 ? 0.0 : rad_from_deg(37.0);
  std::size_t num_in_wing = 0;
  for (std::size_t k = 0; k < 1200; ++k) {
    const double error_rad =
        wrap_to_period(fused.heading_rad[k] - simulated.heading_rad[k] - main_rad, 0.5 * kPi);
    EXPECT_LT(std::abs(error_rad), rad_from_deg(1.0)) << k;
    const bool is_first_wing = k / 150 % 2 == 0;
    if (fused.frame[k] < 0) continue;
    if ((fused.frame[k] == fused.frame[10]) == is_first_wing) ++num_in_wing;
  }
  EXPECT_GT(num_in_wing, 900U) << "of 1200 less a fifth of outliers";
}

TEST(HeadingFusion, AKeyframeThatSeesTwoWingsMeasuresBoth) {
  auto generator = make_generator();
  auto simulated = simulate_headings({.num_keyframes = 200,
                                      .step_noise_rad = rad_from_deg(0.05),
                                      .measurement_noise_rad = rad_from_deg(0.3),
                                      .wing_offset_rad = {0.0, rad_from_deg(30.0)}},
                                     generator);
  const FusedHeadings alone = fuse_headings(simulated.evidence);
  for (std::size_t k = 90; k < 110; ++k) {
    auto& proposals = simulated.evidence[k].proposals;
    HeadingProposal other = proposals.front();
    other.heading_rad += rad_from_deg(k < 100 ? 30.0 : -30.0);
    proposals.push_back(other);
  }
  const FusedHeadings both = fuse_headings(simulated.evidence);
  ASSERT_EQ(both.frames.size(), 2U);
  EXPECT_LT(both.frames[1].sigma_rad, alone.frames[1].sigma_rad);
  EXPECT_GT(both.measured_information[95], 1.5 * alone.measured_information[95]);
}

TEST(HeadingFusion, TheMeasurementIsTheHeadingInTheMap) {
  auto generator = make_generator();
  const auto simulated = simulate_headings(
      {.num_keyframes = 300, .wing_offset_rad = {0.0, 0.0, rad_from_deg(30.0)}}, generator);
  const FusedHeadings fused = fuse_headings(simulated.evidence);
  for (std::size_t k = 0; k < 300; ++k) {
    EXPECT_NEAR(fused.measured_heading_rad[k], fused.heading_rad[k], 1e-6) << k;
    EXPECT_GT(fused.measured_information[k], 1.0 / (0.01 * 0.01)) << k;
    EXPECT_EQ(fused.frame[k], k < 200 ? 0 : 1) << k;
  }
}

TEST(HeadingFusion, SigmaMatchesTheErrors) {
  auto generator = make_generator();
  const HeadingFusionParams params{.building_sigma_rad = rad_from_deg(0.3), .num_alike = 1.0};
  double sum_squares = 0.0;
  constexpr std::size_t kNumKeyframes = 4000;
  const auto simulated = simulate_headings({.num_keyframes = kNumKeyframes,
                                            .step_noise_rad = rad_from_deg(0.1),
                                            .measurement_noise_rad = rad_from_deg(0.316)},
                                           generator);
  const FusedHeadings fused = fuse_headings(simulated.evidence, params);
  const std::vector<double> errors = errors_rad(simulated, fused);
  for (std::size_t k = 0; k < kNumKeyframes; ++k) {
    const double ratio = errors[k] / fused.heading_sigma_rad[k];
    sum_squares += ratio * ratio;
  }
  const double rms = std::sqrt(sum_squares / static_cast<double>(kNumKeyframes));
  EXPECT_GT(rms, 0.8);
  EXPECT_LT(rms, 1.2);
}

TEST(HeadingFusion, SigmaGrowsWhereNoWallIsSeen) {
  auto generator = make_generator();
  auto simulated = simulate_headings({.num_keyframes = 300}, generator);
  for (std::size_t k = 100; k < 200; ++k) simulated.evidence[k].proposals.clear();
  const FusedHeadings fused = fuse_headings(simulated.evidence);
  EXPECT_GT(fused.heading_sigma_rad[150], 1.5 * fused.heading_sigma_rad[50]);
  EXPECT_GT(fused.heading_sigma_rad[150], fused.heading_sigma_rad[110]);
  EXPECT_EQ(fused.frame[150], -1);
  EXPECT_EQ(fused.measured_information[150], 0.0);
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
  EXPECT_TRUE(std::isinf(fused.heading_sigma_rad[1]));
  EXPECT_TRUE(fuse_headings({}).heading_rad.empty());
}

}  // namespace setsquare::heading_fusion_test
