// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/mapping/paper_mapper.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "tests/support/pose_matchers.hpp"
#include "tests/support/simulated_drive.hpp"

namespace setsquare::paper_mapper_test {

using testing::between;
using testing::drive;
using testing::Fan;
using testing::l_shaped_room;
using testing::PoseNear;
using testing::PoseTolerance;
using testing::scan_of_walls;
using testing::scans_on_drive;

/// The paper's sensor: 270 degrees in steps of 0.25.
Fan papers_fan() {
  return {.num_beams = 1081,
          .first_bearing_rad = rad_from_deg(-135.0),
          .bearing_step_rad = rad_from_deg(0.25)};
}

TEST(PaperMapper, FollowsAWayThroughARoom) {
  const std::vector<Pose2> truth = drive({{1.5, 1.5}, {4.5, 2.0}, {2.0, 4.0}}, 0.2);
  PaperMapper mapper;
  for (const Scan& scan : scans_on_drive(l_shaped_room(), truth, 0.01, papers_fan())) {
    mapper.add(scan);
  }
  const Map track = mapper.finish();
  ASSERT_EQ(track.scans.size(), truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    ASSERT_EQ(track.scans[i].status, TrackStatus::kTracked) << i;
    ASSERT_THAT(between(track.scans[0].T_map_sensor, track.scans[i].T_map_sensor),
                PoseNear(between(truth[0], truth[i]),
                         PoseTolerance{.translation_m = 0.15, .rotation_rad = rad_from_deg(1.0)}))
        << i;
  }
  EXPECT_GT(track.keyframes.size(), 10U);
}

TEST(PaperMapper, ARejectedScanStandsStillAndTheWayGoesOn) {
  const std::vector<Pose2> truth = drive({{1.5, 1.5}, {3.5, 1.5}}, 0.2);
  std::vector<Scan> scans = scans_on_drive(l_shaped_room(), truth, 0.01, papers_fan());
  scans[4].ranges_m.assign(1081, 81.83);
  PaperMapper mapper;
  for (const Scan& scan : scans) mapper.add(scan);
  const Map track = mapper.finish();
  EXPECT_EQ(track.scans[4].status, TrackStatus::kLost);
  EXPECT_EQ(track.scans[4].T_map_sensor, track.scans[3].T_map_sensor);
  EXPECT_EQ(track.scans[5].status, TrackStatus::kTracked);
}

TEST(PaperMapper, NeighboursNeverTurnByAQuarter) {
  // A square room looks the same after a quarter turn: only the limit decides.
  const std::vector<testing::Wall> room = {{-3.0, -3.0, 3.0, -3.0},
                                           {3.0, -3.0, 3.0, 3.0},
                                           {3.0, 3.0, -3.0, 3.0},
                                           {-3.0, 3.0, -3.0, -3.0}};
  std::vector<Pose2> truth;
  for (int k = 0; k < 60; ++k) truth.push_back({0.02 * k, -0.01 * k, rad_from_deg(9.0 * k)});
  const auto num_wrong_turns = [&](const PaperMapperParams& params) {
    PaperMapper mapper(params);
    for (const Scan& scan : scans_on_drive(room, truth, 0.01, papers_fan())) mapper.add(scan);
    const Map track = mapper.finish();
    int count = 0;
    for (std::size_t k = 1; k < truth.size(); ++k) {
      const double turn_rad =
          between(track.scans[k - 1].T_map_sensor, track.scans[k].T_map_sensor).theta_rad;
      count += std::abs(wrap_to_pi(turn_rad - rad_from_deg(9.0))) > rad_from_deg(1.0);
    }
    return count;
  };
  EXPECT_EQ(num_wrong_turns({}), 0);
  EXPECT_GT(num_wrong_turns({.matcher = {}}), 0) << "all four offsets: the limit was not needed";
}

TEST(PaperMapper, AfterRejectedScansTheWallsGiveTheHeading) {
  PaperMapperParams params;
  params.max_rejected = 2;
  PaperMapper mapper(params);
  mapper.add(scan_of_walls(l_shaped_room(), {2.0, 2.5, rad_from_deg(7.0)}, papers_fan()));
  // Another place of the same building.
  const auto corridor = testing::bare_corridor();
  mapper.add(scan_of_walls(corridor, {0.0, 0.1, rad_from_deg(17.0)}, papers_fan()));
  mapper.add(scan_of_walls(corridor, {0.0, 0.1, rad_from_deg(27.0)}, papers_fan()));
  const Map track = mapper.finish();
  ASSERT_EQ(track.scans[1].status, TrackStatus::kLost);
  ASSERT_EQ(track.scans[2].status, TrackStatus::kLost);
  EXPECT_EQ(track.keyframes, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(track.scans[1].T_map_sensor, track.scans[0].T_map_sensor);
  EXPECT_THAT(between(track.scans[0].T_map_sensor, track.scans[2].T_map_sensor),
              PoseNear(Pose2{0.0, 0.0, rad_from_deg(20.0)},
                       PoseTolerance{.translation_m = 1e-9, .rotation_rad = rad_from_deg(0.3)}));
}

TEST(PaperMapper, BlankScansCostNoOther) {
  const std::vector<Pose2> truth = drive({{1.5, 1.5}, {3.5, 1.5}}, 0.1);
  for (const std::size_t first : {0U, 4U}) {
    std::vector<Scan> scans = scans_on_drive(l_shaped_room(), truth, 0.01, papers_fan());
    // The robot waits, blinded, for longer than rejected scans are tolerated.
    Scan blank = scans[first];
    blank.ranges_m.assign(1081, std::numeric_limits<double>::quiet_NaN());
    scans.insert(scans.begin() + static_cast<std::ptrdiff_t>(first), 12, blank);
    PaperMapper mapper;
    for (std::size_t i = 0; i < scans.size(); ++i) {
      const TrackedPose tracked = mapper.add(scans[i]);
      const bool is_blank = i >= first && i < first + 12;
      EXPECT_EQ(tracked.status == TrackStatus::kLost, is_blank) << i;
      EXPECT_FALSE(is_blank && tracked.is_keyframe) << i;
    }
    const Map track = mapper.finish();
    EXPECT_EQ(track.keyframes.front(), first == 0 ? 12U : 0U);
    EXPECT_THAT(
        between(track.scans[track.keyframes.front()].T_map_sensor, track.scans.back().T_map_sensor),
        PoseNear(between(truth.front(), truth.back()),
                 PoseTolerance{.translation_m = 0.15, .rotation_rad = rad_from_deg(1.0)}));
  }
}

}  // namespace setsquare::paper_mapper_test
