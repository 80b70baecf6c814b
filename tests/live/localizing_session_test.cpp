// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/localizing_session.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/io/map_file/map_file.hpp"
#include "tests/live/room_log.hpp"
#include "tests/support/temporary_folder.hpp"

namespace setsquare::localizing_session_test {

using live_test::RoomLog;

class LocalizedRoom : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    RoomLog log;
    map_ = std::make_unique<Map>(map_log(log, "room").map);
    grid_ = std::make_unique<OccupancyGrid>(occupancy_grid(*map_));
  }
  static void TearDownTestSuite() {
    grid_.reset();
    map_.reset();
  }

  static RoomLog other_log(std::function<void(std::size_t)> before = {}) {
    return RoomLog(std::move(before), {{4.0, 3.0}, {2.0, 2.0}, {1.5, 7.0}, {3.0, 3.0}});
  }

  /// The log ends where it would if nothing had been said.
  static void expect_end_as_unsaid(const std::vector<LocalisedPose>& said) {
    RoomLog same = other_log();
    const std::vector<LocalisedPose> unsaid =
        localize_log(same, "other", std::make_shared<const KnownMap>(*grid_)).poses;
    ASSERT_EQ(said.size(), unsaid.size());
    EXPECT_EQ(said.back().status, LocalisationStatus::kLocalised);
    const Pose2 apart = unsaid.back().T_map_base.inverse() * said.back().T_map_base;
    EXPECT_LT(std::hypot(apart.x_m, apart.y_m), 0.05);
  }

  static inline std::unique_ptr<Map> map_;
  static inline std::unique_ptr<OccupancyGrid> grid_;
};

TEST_F(LocalizedRoom, GivesWhatLocalizeLogGives) {
  RoomLog log = other_log();
  RoomLog same = other_log();
  LocalizingSession session("other", map_to_localise_in(*grid_), {}, {});
  const LocalizedLog live = session.run(log);
  const LocalizedLog localized =
      localize_log(same, "other", std::make_shared<const KnownMap>(*grid_));
  ASSERT_EQ(live.poses.size(), localized.poses.size());
  for (std::size_t i = 0; i < live.poses.size(); ++i) {
    ASSERT_EQ(live.poses[i].status, localized.poses[i].status) << i;
    ASSERT_EQ(live.poses[i].T_map_base, localized.poses[i].T_map_base) << i;
  }
  EXPECT_EQ(live.name, localized.name);
  EXPECT_EQ(live.format, localized.format);
  EXPECT_EQ(live.sensor, localized.sensor);
  EXPECT_EQ(session.counts().num_localised, counts_of(localized).num_localised);
  EXPECT_EQ(session.report().doing, "localised");
}

// Read from a file or its folder, the map has its own scans, as it has in the program that made it;
// a map.yaml has none.
TEST_F(LocalizedRoom, IsFoundByTheScansOfAMapFile) {
  const testing::TemporaryFolder folder;
  save_map_file(*map_, (folder.path() / kMapFileName).string());
  const MapToLocaliseIn read = read_map_to_localise_in(folder.path().string());
  EXPECT_EQ(read.known->views().size(), placed_keyframes(*map_).size());
  EXPECT_EQ(read.known->views().num_made(), 0U);
  EXPECT_TRUE(map_to_localise_in(*grid_).known->views().empty());
  RoomLog log = other_log();
  RoomLog same = other_log();
  const LocalizedLog by_file = LocalizingSession("other", read, {}, {}).run(log);
  EXPECT_GT(read.known->views().num_made(), 0U);
  const LocalizedLog by_map = localize_log(same, "other", std::make_shared<const KnownMap>(*map_));
  ASSERT_EQ(by_file.poses.size(), by_map.poses.size());
  for (std::size_t i = 0; i < by_file.poses.size(); ++i) {
    ASSERT_EQ(by_file.poses[i].probability, by_map.poses[i].probability) << i;
    ASSERT_EQ(by_file.poses[i].T_map_base, by_map.poses[i].T_map_base) << i;
  }
}

TEST_F(LocalizedRoom, TheWayIsToldAndAPosePerScan) {
  RoomLog log = other_log();
  std::size_t num_poses = 0;
  Trajectory way;
  LocalizingSession session("other",
                            map_to_localise_in(*grid_),
                            {.way_period_s = 1e-6, .max_poses = 0},
                            {.on_pose = [&](const LogRecord&, const LivePose&) { ++num_poses; },
                             .on_way = [&](const Trajectory& told) { way = told; }});
  EXPECT_TRUE(session.run(log).poses.empty());
  EXPECT_EQ(num_poses, log.num_scans());
  ASSERT_GT(way.size(), 50U);
  for (std::size_t i = 1; i < way.size(); ++i) {
    EXPECT_LT((way[i].pose.translation() - way[i - 1].pose.translation()).norm(), 0.3) << i;
  }
}

// Memory does not grow for ever: of the oldest scans no more than how they ended is known.
TEST_F(LocalizedRoom, TheNewestPosesStay) {
  RoomLog log = other_log();
  RoomLog same = other_log();
  LocalizingSession session("other", map_to_localise_in(*grid_), {.max_poses = 30}, {});
  const LocalizedLog bounded = session.run(log);
  const LocalizedLog all = localize_log(same, "other", std::make_shared<const KnownMap>(*grid_));
  ASSERT_EQ(bounded.poses.size(), 30U);
  EXPECT_EQ(bounded.left_out.num_scans(), all.poses.size() - 30);
  for (std::size_t i = 0; i < 30; ++i) {
    EXPECT_EQ(bounded.poses[i].T_map_base, all.poses[all.poses.size() - 30 + i].T_map_base) << i;
  }
  const LocalisationCounts counts = counts_of(bounded);
  EXPECT_EQ(counts.num_localised, counts_of(all).num_localised);
  EXPECT_EQ(counts.num_confirmed, counts_of(all).num_confirmed);
  EXPECT_EQ(counts.first_localised, counts_of(all).first_localised);
}

TEST_F(LocalizedRoom, AResetForgetsWhereItWas) {
  LocalizingSession* running = nullptr;
  std::vector<LivePose> poses;
  RoomLog log = other_log([&](std::size_t scan) {
    if (scan == 60) running->reset();
  });
  LocalizingSession session(
      "other",
      map_to_localise_in(*grid_),
      {},
      {.on_pose = [&](const LogRecord&, const LivePose& pose) { poses.push_back(pose); }});
  running = &session;
  (void)session.run(log);
  EXPECT_FALSE(poses[60].is_placed);
  EXPECT_EQ(session.report().doing, "localised");
}

// Law: whatever is said, the scans decide.
TEST_F(LocalizedRoom, APoseThatIsSaidWronglyIsDropped) {
  LocalizingSession* running = nullptr;
  RoomLog log = other_log([&](std::size_t scan) {
    if (scan != 40) return;
    EXPECT_TRUE(running->set_pose({2.0, 7.5, 1.0}));  // in the other wing
  });
  LocalizingSession session("other", map_to_localise_in(*grid_), {}, {});
  running = &session;
  expect_end_as_unsaid(session.run(log).poses);
}

// A thousand lies: those that are no poses of the map are refused, and the others the scans drop.
TEST_F(LocalizedRoom, AfterAFloodOfPosesItIsWhereItIs) {
  LocalizingSession* running = nullptr;
  std::size_t num_refused = 0;
  RoomLog log = other_log([&](std::size_t scan) {
    if (scan < 20 || scan >= 70) return;
    for (int k = 0; k < 20; ++k) {
      const double way_m = std::pow(10.0, static_cast<double>(k));
      try {
        (void)running->set_pose({way_m, -0.5 * way_m, 1.0 * k});
      } catch (const ParameterError&) {
        ++num_refused;
      }
    }
  });
  LocalizingSession session("other", map_to_localise_in(*grid_), {}, {});
  running = &session;
  expect_end_as_unsaid(session.run(log).poses);
  EXPECT_GE(num_refused, 50U * 18);
}

TEST_F(LocalizedRoom, AMapWithoutWallsIsRefused) {
  const OccupancyGrid nothing({}, 0.05, 20, 20);
  EXPECT_THROW(LocalizingSession("other", map_to_localise_in(nothing), {}, {}), ParameterError);
  LocalizingSession::Options options;
  options.localising.log.sensor = "all";
  EXPECT_THROW(LocalizingSession("other", map_to_localise_in(*grid_), options, {}), ParameterError);
}

}  // namespace setsquare::localizing_session_test
