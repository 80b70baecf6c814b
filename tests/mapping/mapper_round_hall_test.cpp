// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What a map states of its headings, against the truth. Kinds of place: a round hall, empty but for
// its wall, that no scan tells a turn in; and a furnished room. No odometry.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "tests/mapping/tracked_world.hpp"
#include "tests/support/rooms.hpp"

namespace setsquare::mapper_round_hall_test {

constexpr std::uint64_t kNumSeeds = 4;

/// The map of a drive, by its scans alone, and how far off its headings are.
struct HeadingReport {
  HeadingReport(const std::vector<testing::Wall>& walls,
                const std::vector<Pose2>& truth,
                const MapperParams& params = {});

  double worst_error_rad = 0.0;
  double worst_ratio = 0.0;  ///< Of a heading's error to its stated sigma.
  double widest_rad = 0.0;   ///< Stated sigma.
};

HeadingReport::HeadingReport(const std::vector<testing::Wall>& walls,
                             const std::vector<Pose2>& truth,
                             const MapperParams& params) {
  Mapper mapper(params);
  for (const Scan& scan : testing::scans_on_drive(walls, truth, 0.01, testing::kAllAround)) {
    mapper.add(scan);
  }
  const Map map = mapper.finish();
  for (std::size_t i = 0; i < map.scans.size(); ++i) {
    const MappedScan& scan = map.scans[i];
    const double error_rad =
        std::abs(wrap_to_pi(scan.T_map_sensor.theta_rad - truth[i].theta_rad -
                            map.scans[0].T_map_sensor.theta_rad + truth[0].theta_rad));
    worst_error_rad = std::max(worst_error_rad, error_rad);
    worst_ratio = std::max(worst_ratio, error_rad / scan.heading_sigma_rad);
    widest_rad = std::max(widest_rad, scan.heading_sigma_rad);
  }
}

/// The seed draws the hall's radius and a way through it.
HeadingReport report_of_hall(std::uint64_t seed, const MapperParams& params = {}) {
  std::mt19937_64 random(seed);
  const double radius_m = std::uniform_real_distribution<double>(5.0, 9.0)(random);
  std::uniform_real_distribution<double> place_m(-3.0, 3.0);
  std::vector<Eigen::Vector2d> way;
  for (int k = 0; k < 4; ++k) way.emplace_back(place_m(random), place_m(random));
  return {testing::regular_polygon(120, radius_m), testing::drive(way), params};
}

TEST(MapperRoundHall, StatesThatItsHeadingsAreOpenAndHowFar) {
  for (std::uint64_t seed = 1; seed <= kNumSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const HeadingReport report = report_of_hall(seed);
    EXPECT_LT(report.worst_ratio, 3.0) << deg_from_rad(report.worst_error_rad) << " deg";
    EXPECT_GT(report.widest_rad, kOpenHeading_rad);
  }
}

/// The rule switched off: every turn is taken to be bound. One hall: it takes long.
TEST(MapperRoundHall, IsWrongAndSilentWhereTheWallsAreBelieved) {
  MapperParams params;
  params.tracker.refinement.turn = {.noise_rad = 0.0, .bound_rad = 1e-6};
  const HeadingReport report = report_of_hall(1, params);
  EXPECT_GT(report.worst_error_rad, rad_from_deg(5.0));
  EXPECT_GT(report.worst_ratio, 3.0);
}

TEST(MapperRoundHall, AFurnishedRoomStatesThatItsHeadingsAreKnown) {
  for (std::uint64_t seed = 1; seed <= kNumSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const testing::FurnishedRoom room = testing::furnished_room(random);
    // On the spot, all around: furniture is in no place's way.
    const Eigen::Vector2d place_m = testing::free_pose(room, random).translation();
    std::vector<Pose2> truth;
    for (int k = 0; k < 120; ++k) {
      truth.push_back({place_m.x(), place_m.y(), wrap_to_pi(rad_from_deg(3.0 * k))});
    }
    const HeadingReport report(room.walls, truth);
    EXPECT_LT(report.widest_rad, rad_from_deg(2.0));
    EXPECT_LT(report.worst_ratio, 3.0) << deg_from_rad(report.worst_error_rad) << " deg";
  }
}

}  // namespace setsquare::mapper_round_hall_test
