// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/surfaces/angle_histogram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::angle_histogram_test {

constexpr int kNumBins = AngleHistogram::kNumBins;
const testing::Fan kFullTurn{720, -kPi, rad_from_deg(0.5)};

SurfacePoints room_points(const Pose2& pose) {
  return surface_points_from_scan(
      testing::scan_of_walls(testing::l_shaped_room(), pose, kFullTurn, 0.005));
}

TEST(AngleHistogram, HoldsTheLengthOfEveryWallThatHasANormal) {
  const SurfacePoints points = room_points({2.0, 2.5, 0.3});
  const AngleHistogram histogram = angle_histogram(points);
  std::array<double, kNumBins> plain{};
  double length_m = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points.normal_x[i] == 0.0F && points.normal_y[i] == 0.0F) continue;
    const double bearing_rad = std::atan2(points.normal_y[i], points.normal_x[i]);
    length_m += points.weight_m[i];
    plain[std::min(kNumBins - 1, static_cast<int>((bearing_rad + kPi) / kTwoPi * kNumBins))] +=
        points.weight_m[i];
  }
  const double total = std::accumulate(histogram.length_m.begin(), histogram.length_m.end(), 0.0);
  EXPECT_NEAR(total, length_m, 1e-3 * total);
  // The quick arc tangent moves a wall by a bin at most: sums over five bins see it.
  for (int bin = 0; bin < kNumBins; ++bin) {
    double around = 0.0;
    double plain_around = 0.0;
    double plain_wider = 0.0;
    for (int k = -4; k <= 4; ++k) {
      const int near = (bin + k + kNumBins) % kNumBins;
      if (std::abs(k) <= 2) around += histogram.length_m[near];
      if (std::abs(k) <= 0) plain_around += plain[near];
      plain_wider += plain[near];
    }
    EXPECT_GE(around, plain_around - 1e-3) << bin;
    EXPECT_LE(around, plain_wider + 1e-3) << bin;
  }
}

TEST(ProposeRotations, FindsThePeaksOfThePlainCorrelation) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 20; ++trial) {
    AngleHistogram reference;
    AngleHistogram current;
    for (auto* histogram : {&reference, &current}) {
      for (float& length : histogram->length_m) {
        length = static_cast<float>(testing::uniform(generator, 0.0, 1.0));
      }
    }
    std::array<double, kNumBins> plain{};
    for (int lag = 0; lag < kNumBins; ++lag) {
      for (int bin = 0; bin < kNumBins; ++bin) {
        plain[lag] +=
            static_cast<double>(reference.length_m[(bin + lag) % kNumBins]) * current.length_m[bin];
      }
    }
    const auto best =
        static_cast<int>(std::max_element(plain.begin(), plain.end()) - plain.begin());
    const auto proposals = propose_rotations(reference, current, 5);
    ASSERT_EQ(proposals.size(), 5U);
    EXPECT_LE(std::abs(wrap_to_pi(proposals[0].rotation_rad - best * kTwoPi / kNumBins)),
              0.5 * kTwoPi / kNumBins + 1e-9);
    for (std::size_t k = 1; k < proposals.size(); ++k) {
      EXPECT_GE(proposals[k - 1].correlation, proposals[k].correlation);
      EXPECT_LE(proposals[k].correlation, 1.0);
      for (std::size_t other = 0; other < k; ++other) {
        EXPECT_GT(std::abs(wrap_to_pi(proposals[k].rotation_rad - proposals[other].rotation_rad)),
                  kTwoPi / kNumBins);
      }
    }
  }
}

TEST(ProposeRotations, FindTheTurnBetweenTwoScans) {
  auto generator = testing::make_generator();
  for (int trial = 0; trial < 40; ++trial) {
    const double turn_rad = testing::uniform(generator, -kPi, kPi);
    const auto reference = angle_histogram(room_points({2.0, 2.5, 0.2}));
    const auto current = angle_histogram(room_points({2.3, 2.2, 0.2 + turn_rad}));
    const auto proposals = propose_rotations(reference, current, 6);
    ASSERT_FALSE(proposals.empty());
    double nearest_rad = 1e9;
    for (const auto& proposal : proposals) {
      nearest_rad = std::min(nearest_rad, std::abs(wrap_to_pi(proposal.rotation_rad - turn_rad)));
    }
    EXPECT_LT(nearest_rad, rad_from_deg(2.0)) << "turn " << deg_from_rad(turn_rad);
  }
}

TEST(ProposeRotations, KnowNothingOfScansWithoutWalls) {
  const AngleHistogram empty;
  const auto room = angle_histogram(room_points({2.0, 2.5, 0.0}));
  EXPECT_TRUE(propose_rotations(empty, room, 6).empty());
  EXPECT_TRUE(propose_rotations(room, empty, 6).empty());
  EXPECT_TRUE(propose_rotations(empty, empty, 6).empty());
}

}  // namespace setsquare::angle_histogram_test
