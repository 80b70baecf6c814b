// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/surfaces/sample_comparison.hpp"

#include <gtest/gtest.h>

#include "setsquare/surfaces/prepared_scan.hpp"
#include "tests/support/rooms.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::sample_comparison_test {

constexpr float kInverseTolerance = 5.0F;

TEST(SampleComparison, FourAtOnceSayWhatEachSays) {
  auto generator = testing::make_generator();
  const auto room = testing::furnished_room(generator);
  const Pose2 T = testing::free_pose(room, generator);
  const Pose2 other = testing::free_pose(room, generator);
  const testing::Fan fan{360, -kPi, rad_from_deg(1)};
  const auto surfaces = scan_surfaces(testing::scan_of_walls(room.walls, T, fan, 0.01, 1));
  const PreparedScan moved = prepare(testing::scan_of_walls(room.walls, other, fan, 0.01, 2, 0.05));
  const SurfaceSamples& samples = moved.dense;
  const Pose2 T_image_samples = T.inverse() * other;
  const Motion<float> motion(T_image_samples);
  std::size_t num_compared = 0;
  compare_by_fours(
      surfaces->image, samples, T_image_samples, [&](std::size_t first, const auto& four) {
        const Floats weight = facing_weight(four);
        const Floats nearness = four.nearness(spread(kInverseTolerance));
        for (std::size_t lane = 0; lane < kLanes && first + lane < samples.size(); ++lane) {
          const std::size_t i = first + lane;
          const SampleComparison<float> one(surfaces->image,
                                            moved_sample(motion,
                                                         samples.x_m[i],
                                                         samples.y_m[i],
                                                         samples.normal_x[i],
                                                         samples.normal_y[i]));
          ASSERT_EQ(four.distance_m[lane], one.distance_m);
          ASSERT_EQ(weight[lane], facing_weight(one));
          ASSERT_EQ(nearness[lane], one.nearness(kInverseTolerance));
          ASSERT_EQ(four.is_in_free_space()[lane] != 0, one.is_in_free_space());
          ASSERT_EQ(four.has_surface()[lane] != 0, one.has_surface());
          ++num_compared;
        }
      });
  EXPECT_EQ(num_compared, samples.size());
  EXPECT_GT(num_compared, 100U);
}

TEST(SampleComparison, CountsByTheWayThatASampleFaces) {
  const auto surfaces =
      scan_surfaces(testing::scan_of_walls(testing::empty_rectangle(4.0, 4.0), {2.0, 2.0, 0.0}));
  const auto compare = [&](float x_m, float normal_x, float normal_y) {
    return SampleComparison<float>(surfaces->image, {x_m, 0.0F, x_m, 0.0F, normal_x, normal_y});
  };
  EXPECT_NEAR(compare(1.9F, -1.0F, 0.0F).distance_m, 0.1F, 0.01F) << "before the wall at 2 m";
  EXPECT_NEAR(compare(2.1F, -1.0F, 0.0F).distance_m, -0.1F, 0.01F) << "behind it";
  EXPECT_EQ(facing_weight(compare(2.0F, -1.0F, 0.0F)), 1.0F);
  EXPECT_EQ(facing_weight(compare(2.0F, 1.0F, 0.0F)), 0.0F);
  EXPECT_EQ(facing_weight(compare(2.0F, 0.0F, 1.0F)), 0.0F);
  EXPECT_EQ(facing_weight(compare(2.0F, 0.0F, 0.0F)), kClutterWeight);
}

}  // namespace setsquare::sample_comparison_test
