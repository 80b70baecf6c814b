// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Long steps that matches second: by made-up matches, and in simulated buildings of which each
// metre of the way has a scan, one step of them wrong.
#include "setsquare/mapping/audit/unseconded_steps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "setsquare/mapping/audit/audit.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"
#include "tests/mapping/driven_building.hpp"

namespace setsquare::unseconded_steps_test {

/// Ten keyframes, a metre from each to the next.
AuditedTrack straight_track() {
  AuditedTrack track;
  for (std::size_t k = 0; k < 10; ++k) {
    track.keyframes.push_back(k);
    track.T_map_sensor.push_back({static_cast<double>(k), 0.0, 0.0});
    track.way_m.push_back(static_cast<double>(k));
    track.open_m2.push_back(0.0);
    if (k > 0) track.long_steps.push_back(k);
  }
  return track;
}

/// A match that has the later keyframe so far from where the map has it.
AuditMatch match_of(std::size_t from, std::size_t to, double off_m = 0.0, double off_rad = 0.0) {
  return {{from, to},
          {static_cast<double>(to - from) + off_m, 0.0, off_rad},
          Eigen::Matrix3d::Identity()};
}

using Steps = std::vector<std::size_t>;

Steps left_by(const std::vector<AuditMatch>& matches) {
  const AuditedTrack track = straight_track();
  return without_second(track.long_steps, matches, track, {});
}

TEST(UnsecondedSteps, AMatchSecondsEachStepThatItSpans) {
  EXPECT_EQ(left_by({}).size(), 9U);
  EXPECT_EQ(left_by({match_of(0, 1), match_of(2, 5), match_of(6, 8)}), (Steps{2, 6, 9}));
}

TEST(UnsecondedSteps, AMatchThatContradictsTheMapSecondsNone) {
  EXPECT_EQ(left_by({match_of(0, 1, 0.4)}).size(), 9U);
  EXPECT_EQ(left_by({match_of(0, 1, 0.0, rad_from_deg(8.0))}).size(), 9U);
}

TEST(UnsecondedSteps, OneThatAgreesIsNotEnoughAgainstOthers) {
  EXPECT_EQ(left_by({match_of(3, 4), match_of(3, 5, 1.0)}), (Steps{1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(left_by({match_of(3, 4), match_of(2, 4), match_of(3, 5, 1.0)}),
            (Steps{1, 2, 5, 6, 7, 8, 9}));
}

TEST(UnsecondedSteps, AMatchOverManyStepsTellsOfNone) {
  EXPECT_EQ(left_by({match_of(0, 4)}).size(), 9U);
}

Steps astray_by(const std::vector<AuditMatch>& matches) {
  return astray_keyframes(matches, straight_track(), {});
}

// The two steps about a place may be wrong, and together right.
TEST(AstrayKeyframes, AreSecondedByNoneWhileMatchesOverThemAgree) {
  const AuditMatch over = match_of(3, 5);
  EXPECT_EQ(left_by({over}), (Steps{1, 2, 3, 6, 7, 8, 9})) << "the step alone tells nothing";
  EXPECT_EQ(astray_by({over}), (Steps{4}));
  EXPECT_EQ(astray_by({over, match_of(4, 5, 3.9)}), (Steps{4}));
  EXPECT_EQ(astray_by({over, match_of(4, 5, 0.0, kPi), match_of(3, 4)}), (Steps{4}));
  EXPECT_EQ(astray_by({over, match_of(3, 4)}), Steps{});
  EXPECT_EQ(astray_by({over, match_of(4, 5, 3.9), match_of(3, 4), match_of(2, 4)}), Steps{});
  EXPECT_EQ(astray_by({match_of(4, 5, 3.9)}), Steps{}) << "that is a step that nothing seconds";
}

/// A building of which each metre of the way has a scan.
struct KeyFrames {
  Map map;
  std::vector<ScanSurfacesPtr> surfaces;
};

KeyFrames key_frames(BuildingClass building_class, std::uint64_t seed) {
  const DrivenBuilding drive = driven_building(building_class, seed, 5.0);
  KeyFrames frames;
  std::size_t num_scans = 0;
  for (std::size_t i = 0; i < drive.scans.size(); ++i) {
    const Pose2& T_map_sensor = drive.T_map_sensor[i];
    if (num_scans > 0) {
      const Pose2 moved = frames.map.scans.back().T_map_sensor.inverse() * T_map_sensor;
      if (moved.translation().norm() < 1.0 && std::abs(moved.theta_rad) < rad_from_deg(30.0)) {
        continue;
      }
    }
    MappedScan mapped;
    mapped.T_map_base = mapped.T_map_sensor = T_map_sensor;
    mapped.status = TrackStatus::kTracked;
    frames.map.scans.push_back(mapped);
    frames.map.keyframes.push_back(num_scans++);
    frames.map.track.motions.emplace_back();
    frames.map.track.motions.back().covariance.is_long_step = true;
    frames.surfaces.push_back(scan_surfaces(drive.scans[i]));
  }
  frames.map.pieces = {{0, num_scans, true}};
  return frames;
}

/// All from the scan on moved about it.
void make_wrong_step(std::size_t scan, const Pose2& T_scan_wrong, Map& map) {
  const Pose2 T_right = map.scans[scan].T_map_sensor;
  const Pose2 T_wrong_right = T_right * T_scan_wrong * T_right.inverse();
  for (std::size_t i = scan; i < map.scans.size(); ++i) {
    map.scans[i].T_map_base = map.scans[i].T_map_sensor = T_wrong_right * map.scans[i].T_map_sensor;
  }
}

TEST(UnsecondedSteps, InBuildingsWrongStepsAreFoundAndRightOnesAreFew) {
  std::size_t num_right = 0;
  std::size_t num_left = 0;
  for (const BuildingClass building_class : {BuildingClass::kOffice, BuildingClass::kWings}) {
    for (const std::uint64_t seed : {4001U, 4002U}) {
      KeyFrames frames = key_frames(building_class, seed);
      const AuditFindings right = audit(frames.map, frames.surfaces, {}, 2);
      num_right += frames.map.scans.size() - 1;
      num_left += right.unseconded.size();
      const std::size_t wrong = frames.map.scans.size() / 2;
      make_wrong_step(wrong, {1.5, 0.5, rad_from_deg(90.0)}, frames.map);
      const AuditFindings found = audit(frames.map, frames.surfaces, {}, 2);
      EXPECT_TRUE(std::ranges::find(found.unseconded, wrong) != found.unseconded.end()) << seed;
    }
  }
  EXPECT_GT(num_right, 80U);
  EXPECT_LT(num_left, num_right / 10) << num_left << " of " << num_right;
}

TEST(UnsecondedSteps, WhereStepsAreShortNothingIsAsked) {
  KeyFrames frames = key_frames(BuildingClass::kOffice, 4003);
  for (TrackedMotion& motion : frames.map.track.motions) motion.covariance.is_long_step = false;
  make_wrong_step(frames.map.scans.size() / 2, {1.5, 0.5, 1.5}, frames.map);
  EXPECT_TRUE(audit(frames.map, frames.surfaces, {}, 2).unseconded.empty());
}

}  // namespace setsquare::unseconded_steps_test
