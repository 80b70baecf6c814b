// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/paper/profile_correlation.hpp"

#include <gtest/gtest.h>

#include "setsquare/core/error.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::profile_correlation_test {

std::vector<double> random_coordinates(std::mt19937_64& generator,
                                       std::size_t size,
                                       double half_width_m) {
  std::vector<double> coordinates_m(size);
  for (double& value : coordinates_m) {
    value = testing::uniform(generator, -half_width_m, half_width_m);
  }
  return coordinates_m;
}

/// Eqs. (9) and (10) literally: the current scan is binned again for every shift.
std::vector<std::int32_t> correlate_by_binning_again(const ProjectedProfile& reference,
                                                     const std::vector<double>& current_m,
                                                     const ShiftSearch& search) {
  std::vector<std::int32_t> correlation;
  for (std::int64_t lag = -search.max_lag(); lag <= search.max_lag(); ++lag) {
    const double shift_m = static_cast<double>(lag) * search.step_m;
    const auto moved = profile_of_coordinates(current_m, reference.bins, shift_m);
    std::int32_t sum = 0;
    for (std::size_t k = 0; k < moved.counts.size(); ++k) {
      sum += reference.counts[k] * moved.counts[k];
    }
    correlation.push_back(sum);
  }
  return correlation;
}

TEST(Correlate, EqualsEquationNineLiterally) {
  std::mt19937_64 generator = testing::make_generator();
  for (const ShiftSearch& search :
       {ShiftSearch{}, ShiftSearch{0.4, 0.04}, ShiftSearch{0.1, 0.02}, ShiftSearch{0.0, 0.005}}) {
    // Points beyond the range, which a shift may bring in, and far beyond, which none does.
    const auto current_m = random_coordinates(generator, 200, 14.0);
    const auto reference =
        profile_of_coordinates(random_coordinates(generator, 200, 11.0), ProfileBins{});
    EXPECT_EQ(correlate(reference, current_m, search),
              correlate_by_binning_again(reference, current_m, search));
  }
}

TEST(Correlate, EqualsEquationNineOnANarrowRange) {
  std::mt19937_64 generator = testing::make_generator();
  const auto current_m = random_coordinates(generator, 50, 3.0);
  const auto reference =
      profile_of_coordinates(random_coordinates(generator, 50, 0.5), ProfileBins{0.1, 0.5});
  const ShiftSearch search{2.0, 0.025};  // Shifts wider than the profile.
  EXPECT_EQ(correlate(reference, current_m, search),
            correlate_by_binning_again(reference, current_m, search));
}

TEST(Correlate, FindsTheShiftOfAMovedCopy) {
  std::mt19937_64 generator = testing::make_generator();
  const auto reference_m = random_coordinates(generator, 80, 6.0);
  auto current_m = reference_m;
  for (double& value : current_m) value -= 1.235;
  const ShiftSearch search;
  const auto reference = profile_of_coordinates(reference_m, ProfileBins{});
  const auto correlation = correlate(reference, current_m, search);
  ASSERT_EQ(correlation.size(), 1001U);
  EXPECT_NEAR(search.shift_m(first_peak(correlation)), 1.235, 0.0401);
}

TEST(Correlate, OfFarAwayPointsIsZero) {
  const auto reference = profile_of_coordinates(std::vector<double>{0.0}, ProfileBins{});
  const std::vector<double> far_m = {1e300, -1e300, 1e9, -13.0, 13.0};
  for (const std::int32_t value : correlate(reference, far_m, ShiftSearch{})) EXPECT_EQ(value, 0);
  for (const std::int32_t value : correlate(reference, {}, ShiftSearch{})) EXPECT_EQ(value, 0);
}

TEST(FirstPeak, IsTheFirstOfEqualOnesAndTheMiddleOfNothing) {
  EXPECT_EQ(first_peak(std::vector<std::int32_t>{0, 2, 5, 5, 1}), 2U);
  EXPECT_EQ(first_peak(std::vector<std::int32_t>{0, 0, 0, 0, 0}), 2U);
}

TEST(ShiftSearch, RefusesStepsThatDoNotFit) {
  EXPECT_NO_THROW(ShiftSearch{}.validate(ProfileBins{}));
  EXPECT_THROW((ShiftSearch{2.5, 0.0}.validate(ProfileBins{})), ParameterError);
  EXPECT_THROW((ShiftSearch{2.5, 0.025}.validate(ProfileBins{})), ParameterError);
  EXPECT_THROW((ShiftSearch{2.503, 0.005}.validate(ProfileBins{})), ParameterError);
  EXPECT_THROW((ShiftSearch{-1.0, 0.005}.validate(ProfileBins{})), ParameterError);
}

}  // namespace setsquare::profile_correlation_test
