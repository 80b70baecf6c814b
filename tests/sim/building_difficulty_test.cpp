// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/pairs/pair_geometry.hpp"
#include "setsquare/sim/pairs/study_sampling.hpp"
#include "setsquare/sim/sensing/simulated_scan.hpp"

// How hard the buildings are, by their geometry alone: nothing here knows a matcher.

namespace setsquare::building_difficulty_test {

struct Difficulty {
  double clutter_returns = 0.0;
  double returns = 0.0;
  double pairs = 0.0;
  double pairs_below_60 = 0.0;
  double pairs_from_45 = 0.0;
  double undetermined = 0.0;  ///< Of those from 45 %.
};

void count_pair(const PairGeometry& pair, Difficulty& sum) {
  sum.pairs += 1.0;
  if (pair.overlap < 0.6) sum.pairs_below_60 += 1.0;
  if (pair.overlap < 0.45) return;
  sum.pairs_from_45 += 1.0;
  if (!pair.is_determined()) sum.undetermined += 1.0;
}

void add_building(BuildingClass building_class, std::uint64_t seed, Difficulty& sum) {
  const Building building = make_building(building_class, seed);
  const RobotPath path(building.route_m);
  const RayCaster caster(building.plan);
  const ScannerModel scanner = utm_30lx();
  Random random(sub_seed(seed, 1));
  const std::vector<double> times = study_times(path, 16, random);
  for (const double time : times) {
    const SimulatedScan seen = simulate_scan(caster, building.people, scanner, path, time, random);
    const auto num_beams = static_cast<double>(seen.scan.num_beams());
    sum.clutter_returns += seen.clutter_share * num_beams;
    sum.returns += num_beams;
  }
  for (std::size_t i = 0; i < times.size(); ++i)
    for (std::size_t j = i + 1; j < times.size(); ++j) {
      const Pose2 reference = path.pose_at(times[i]);
      const Pose2 current = path.pose_at(times[j]);
      if ((reference.translation() - current.translation()).norm() <= 5.0)
        count_pair(pair_geometry(caster, scanner, reference, current), sum);
    }
}

TEST(BuildingDifficultyTest, HalfOfThePairsOverlapLittleAndAFifthOfTheReturnsAreClutter) {
  Difficulty pooled;
  for (const BuildingClass building_class : kAllBuildingClasses) {
    Difficulty sum;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      add_building(building_class, seed, sum);
      add_building(building_class, seed, pooled);
    }
    const std::string name(to_string(building_class));
    EXPECT_GE(sum.clutter_returns / sum.returns, 0.15) << name;
    EXPECT_GE(sum.pairs_below_60 / sum.pairs, 0.3) << name;
    RecordProperty(name + "_clutter", std::to_string(sum.clutter_returns / sum.returns));
    RecordProperty(name + "_below_60", std::to_string(sum.pairs_below_60 / sum.pairs));
    RecordProperty(name + "_undetermined", std::to_string(sum.undetermined / sum.pairs_from_45));
  }
  EXPECT_GE(pooled.clutter_returns / pooled.returns, 0.2);
  EXPECT_GE(pooled.pairs_below_60 / pooled.pairs, 0.48);  // A half over many seeds.
  EXPECT_LE(pooled.undetermined / pooled.pairs_from_45, 0.05);
}

}  // namespace setsquare::building_difficulty_test
