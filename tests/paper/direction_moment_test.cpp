// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/paper/direction_moment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::direction_moment_test {

std::vector<std::int32_t> random_profile(std::mt19937_64& generator, std::size_t size) {
  std::vector<std::int32_t> profile(size, 0);
  for (std::int32_t& count : profile) {
    const double draw = testing::uniform(generator, -20.0, 8.0);
    count = draw > 0.0 ? static_cast<std::int32_t>(draw) : 0;
  }
  return profile;
}

/// Eq. (7) by a plain Fourier transform of the profile, followed by zeros up to `length`:
/// (1/pi) times the integral over [0, pi] of weight(omega) |H|^2, as the mean over the circle.
double moment_by_fourier(const std::vector<std::int32_t>& profile,
                         std::size_t length,
                         const std::function<double(double)>& weight) {
  double sum = 0.0;
  for (std::size_t k = 0; k < length; ++k) {
    const double omega = wrap_to_pi(kTwoPi * static_cast<double>(k) / static_cast<double>(length));
    std::complex<double> transform = 0.0;
    for (std::size_t i = 0; i < profile.size(); ++i) {
      transform +=
          static_cast<double>(profile[i]) * std::polar(1.0, -omega * static_cast<double>(i));
    }
    sum += weight(omega) * std::norm(transform);
  }
  return sum / static_cast<double>(length);
}

double four_sin_squared(double omega) {
  return 4.0 * std::sin(0.5 * omega) * std::sin(0.5 * omega);
}

TEST(DirectionMoment, NeighbourDifferencesAreTheFourierMomentWithFourSineSquared) {
  std::mt19937_64 generator = testing::make_generator();
  for (const std::size_t size : {1, 2, 7, 100, 500}) {
    const auto profile = random_profile(generator, size);
    const double expected = moment_by_fourier(profile, size + 1, four_sin_squared);
    EXPECT_NEAR(direction_moment(profile, DirectionMoment::kNeighbourDifferences),
                expected,
                1e-9 * (1.0 + expected));
  }
}

TEST(DirectionMoment, SquaredFrequencyIsTheLimitOfTheFourierMoment) {
  std::mt19937_64 generator = testing::make_generator();
  const auto profile = random_profile(generator, 40);
  const double moment = direction_moment(profile, DirectionMoment::kSquaredFrequency);
  const auto squared = [](double omega) { return omega * omega; };
  // The mean over the circle tends to the integral with the square of the step.
  const auto error = [&](std::size_t length) {
    return std::abs(moment_by_fourier(profile, length, squared) - moment) / moment;
  };
  EXPECT_LT(error(320), 1e-3);
  EXPECT_LT(error(2560), 1e-3 / 64.0);
}

TEST(DirectionMoment, OfOnePointIsKnown) {
  const std::vector<std::int32_t> one = {0, 0, 3, 0};
  EXPECT_DOUBLE_EQ(direction_moment(one, DirectionMoment::kNeighbourDifferences), 18.0);
  EXPECT_DOUBLE_EQ(direction_moment(one, DirectionMoment::kSquaredFrequency),
                   9.0 * kPi * kPi / 3.0);
}

TEST(DirectionMoment, OfAnEmptyProfileIsZero) {
  const std::vector<std::int32_t> empty(10, 0);
  EXPECT_EQ(direction_moment(empty, DirectionMoment::kNeighbourDifferences), 0.0);
  EXPECT_EQ(direction_moment(empty, DirectionMoment::kSquaredFrequency), 0.0);
}

}  // namespace setsquare::direction_moment_test
