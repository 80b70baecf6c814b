// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/tracking/jolt.hpp"

#include <gtest/gtest.h>

#include <random>

#include "setsquare/core/angle.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::jolt_test {

using testing::uniform;

const Pose2 kExpected{2.0, -1.0, 0.3};

/// `ahead_m` and `turn_deg` off the expected place.
Pose2 off(double ahead_m, double turn_deg = 0.0) {
  return kExpected * Pose2{ahead_m, 0.0, rad_from_deg(turn_deg)};
}

TEST(Jolt, IsAStepAsideOrATurn) {
  EXPECT_FALSE(is_jolt(kExpected, kExpected, {}));
  EXPECT_FALSE(is_jolt(kExpected, off(0.09), {}));
  EXPECT_FALSE(is_jolt(kExpected, off(0.0, 4.9), {}));
  EXPECT_TRUE(is_jolt(kExpected, off(0.11), {}));
  EXPECT_TRUE(is_jolt(kExpected, off(0.0, -5.1), {}));
  EXPECT_TRUE(is_jolt(kExpected, off(0.08, 4.0), {})) << "most of both";
}

TEST(Jolt, IsContradictedByAWitnessOnTheRobotsWay) {
  EXPECT_TRUE(is_contradicted(kExpected, off(0.2), kExpected, {}));
  EXPECT_TRUE(is_contradicted(kExpected, off(0.0, 9.0), off(0.02, 1.0), {}));
  EXPECT_FALSE(is_contradicted(kExpected, off(0.2), off(0.2), {})) << "the same place";
  EXPECT_FALSE(is_contradicted(kExpected, off(0.2), off(0.15), {})) << "nearer to that";
}

TEST(Jolt, IsNotContradictedByAPlaceThatLooksTheSameFartherOff) {
  EXPECT_FALSE(is_contradicted(kExpected, off(0.2), off(-5.0), {}));
  EXPECT_FALSE(is_contradicted(kExpected, off(0.2), off(0.0, 180.0), {}));
}

/// Where the frame lies does not matter; nor which way round the step is seen.
TEST(Jolt, DoesNotDependOnTheFrame) {
  std::mt19937_64 generator = testing::make_generator();
  const auto draw = [&] {
    const double x_m = uniform(generator, -0.3, 0.3);
    const double y_m = uniform(generator, -0.3, 0.3);
    return kExpected * Pose2{x_m, y_m, rad_from_deg(uniform(generator, -15.0, 15.0))};
  };
  int num_jolts = 0;
  int num_contradicted = 0;
  for (int i = 0; i < 200; ++i) {
    const Pose2 place = draw();
    const Pose2 witness = draw();
    const Pose2 T = draw();
    const bool jolt = is_jolt(kExpected, place, {});
    const bool contradicted = is_contradicted(kExpected, place, witness, {});
    EXPECT_EQ(is_jolt(T * kExpected, T * place, {}), jolt);
    EXPECT_EQ(is_contradicted(T * kExpected, T * place, T * witness, {}), contradicted);
    num_jolts += jolt;
    num_contradicted += contradicted;
  }
  EXPECT_GT(num_jolts, 100);
  EXPECT_GT(num_contradicted, 20);
  EXPECT_LT(num_contradicted, 180);
}

}  // namespace setsquare::jolt_test
