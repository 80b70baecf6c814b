// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Two wings of which the tracked turns at the joints are wrong, alike every time, so that walls and
// tracking agree on a wrong angle between them; and places seen from both. Kind of place: buildings
// that are not square throughout, where tracking errs at the joints.
#include "setsquare/mapping/outvoted_walls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "tests/headings/simulated_headings.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::outvoted_walls_test {

using testing::simulate_headings;
using testing::SimulatedHeadings;
using testing::uniform;

constexpr std::size_t kNumDraws = 40;
constexpr std::size_t kNumKeyframes = 400;
constexpr std::size_t kPerWing = 100;
constexpr double kWay_m = 0.5;  ///< From keyframe to keyframe.

double normal(std::mt19937_64& generator, double sigma) {
  return std::normal_distribution<double>(0.0, sigma)(generator);
}

double either_sign(std::mt19937_64& generator, double low, double high) {
  return (uniform(generator, 0.0, 1.0) < 0.5 ? -1.0 : 1.0) * uniform(generator, low, high);
}

/// A way from the first wing to the second, back, and to the second again.
struct TwoWings {
  /// Tracking errs by `slip_rad` on the way to the second wing, and by as much on the way back.
  TwoWings(double angle_rad, double slip_rad, std::mt19937_64& generator)
      : simulated(simulate_headings({.num_keyframes = kNumKeyframes,
                                     .step_noise_rad = rad_from_deg(0.03),
                                     .measurement_noise_rad = rad_from_deg(0.3),
                                     .wing_offset_rad = {0.0, angle_rad},
                                     .keyframes_per_wing = kPerWing},
                                    generator)) {
    for (std::size_t k = 0; k < kNumKeyframes; ++k) {
      HeadingEvidence& keyframe = simulated.evidence[k];
      keyframe.is_step_confirmed = true;
      if (k / kPerWing % 2 == 1) keyframe.tracked_heading_rad += slip_rad;
      ways_m.push_back(kWay_m * static_cast<double>(k));
    }
  }

  /// Keyframe `to` seen from `from`, off by so much and some noise.
  void see(std::size_t from, std::size_t to, double off_rad, std::mt19937_64& generator) {
    const double turned_rad = simulated.heading_rad[to] - simulated.heading_rad[from];
    seen.push_back({.from = from,
                    .to = to,
                    .turned_rad = wrap_to_pi(turned_rad + off_rad + normal(generator, 0.004)),
                    .sigma_rad = rad_from_deg(0.1)});
  }

  /// Each wing from the other, and again from itself, a place every seven keyframes.
  void see_all(std::mt19937_64& generator) {
    for (std::size_t i = 0; i < 5; ++i) {
      see(10 + 7 * i, 210 + 7 * i, 0.0, generator);
      see(110 + 7 * i, 310 + 7 * i, 0.0, generator);
    }
    for (std::size_t i = 0; i < 8; ++i) see(44 + 7 * i, 137 + 7 * i, 0.0, generator);
  }

  [[nodiscard]] FusedHeadings fused(const std::vector<TurnedWalls>& turned = {}) const {
    return fuse_headings(simulated.evidence, {}, turned);
  }

  [[nodiscard]] std::vector<TurnedWalls> outvoted() const {
    return outvoted_walls(fused(), simulated.evidence, ways_m, seen, {});
  }

  /// The largest error, apart from the first keyframe's.
  [[nodiscard]] double worst_rad(const FusedHeadings& headings) const {
    double worst = 0.0;
    for (std::size_t k = 0; k < kNumKeyframes; ++k) {
      const double off_rad = headings.heading_rad[k] - simulated.heading_rad[k] -
                             headings.heading_rad[0] + simulated.heading_rad[0];
      worst = std::max(worst, std::abs(wrap_to_pi(off_rad)));
    }
    return worst;
  }

  SimulatedHeadings simulated;
  std::vector<double> ways_m;
  std::vector<SeenTurn> seen;
};

TEST(OutvotedWalls, AWrongFrameIsOutvoted) {
  std::mt19937_64 generator = testing::make_generator();
  for (std::size_t draw = 0; draw < kNumDraws; ++draw) {
    const double angle_rad = either_sign(generator, rad_from_deg(5.0), rad_from_deg(14.0));
    double slip_rad =
        angle_rad;  // Which would hide the joint: its walls would seem to go on, or slip.
    while (std::abs(angle_rad - slip_rad) < rad_from_deg(5.0)) {
      slip_rad = either_sign(generator, rad_from_deg(3.0), rad_from_deg(8.0));
    }
    TwoWings wings(angle_rad, slip_rad, generator);
    wings.see_all(generator);
    EXPECT_GT(wings.worst_rad(wings.fused()), rad_from_deg(2.5)) << "without it, draw " << draw;
    EXPECT_LT(wings.worst_rad(wings.fused(wings.outvoted())), rad_from_deg(1.0))
        << "draw " << draw << ": " << deg_from_rad(angle_rad) << ", " << deg_from_rad(slip_rad);
  }
}

TEST(OutvotedWalls, RightFramesStayWhateverOnePlaceShows) {
  std::mt19937_64 generator = testing::make_generator();
  for (std::size_t draw = 0; draw < kNumDraws; ++draw) {
    const double angle_rad = either_sign(generator, rad_from_deg(5.0), rad_from_deg(14.0));
    TwoWings wings(angle_rad, 0.0, generator);
    wings.see_all(generator);
    const double off_rad = either_sign(generator, rad_from_deg(2.0), rad_from_deg(19.0));
    for (std::size_t i = 0; i < 3; ++i) wings.see(50 + i, 150 + i, off_rad, generator);
    EXPECT_TRUE(wings.outvoted().empty()) << draw;
    EXPECT_EQ(num_places_against(wings.fused(), wings.ways_m, wings.seen, {}), 1U) << draw;
  }
}

TEST(OutvotedWalls, WrongClosuresThatDoNotAgreeTurnNothing) {
  std::mt19937_64 generator = testing::make_generator();
  for (std::size_t draw = 0; draw < kNumDraws; ++draw) {
    TwoWings wings(rad_from_deg(9.0), 0.0, generator);
    wings.see_all(generator);
    for (std::size_t i = 0; i < 3; ++i) {
      const double off_rad = rad_from_deg(4.0 + 5.0 * static_cast<double>(i));
      wings.see(30 + 20 * i, 130 + 20 * i, i % 2 == 0 ? off_rad : -off_rad, generator);
    }
    EXPECT_TRUE(wings.outvoted().empty()) << draw;
  }
}

TEST(OutvotedWalls, TwoPlacesAreTooFew) {
  std::mt19937_64 generator = testing::make_generator();
  TwoWings wings(rad_from_deg(9.0), rad_from_deg(-5.0), generator);
  wings.see(60, 160, 0.0, generator);
  wings.see(80, 180, 0.0, generator);
  EXPECT_TRUE(wings.outvoted().empty());
  wings.see(70, 170, 0.0, generator);
  EXPECT_FALSE(wings.outvoted().empty());
}

TEST(OutvotedWalls, AnOpenRotationSaysNothing) {
  Eigen::Matrix3d information = Eigen::Vector3d(100.0, 0.0, 400.0).asDiagonal();
  EXPECT_NEAR(seen_turn(0, 1, {}, information).sigma_rad, 0.05, 1e-9);
  information(0, 2) = information(2, 0) = 200.0;  // The rotation is that of the translation.
  EXPECT_GT(seen_turn(0, 1, {}, information).sigma_rad, 0.5);
}

TEST(OutvotedWalls, RefuseWrongParameters) {
  EXPECT_THROW(OutvotedWallsParams{.min_turn_rad = 0.0}.validate(), ParameterError);
  EXPECT_THROW(OutvotedWallsParams{.min_places = 0}.validate(), ParameterError);
  EXPECT_THROW(OutvotedWallsParams{.min_majority = -1.0}.validate(), ParameterError);
  EXPECT_NO_THROW(OutvotedWallsParams{}.validate());
}

}  // namespace setsquare::outvoted_walls_test
