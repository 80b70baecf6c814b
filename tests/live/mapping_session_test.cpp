// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/mapping_session.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "setsquare/core/error.hpp"
#include "tests/live/room_log.hpp"

namespace setsquare {
namespace mapping_session_test {

using live_test::RoomLog;

void expect_same_trajectory(const Map& a, const Map& b) {
  ASSERT_EQ(a.scans.size(), b.scans.size());
  for (std::size_t i = 0; i < a.scans.size(); ++i) {
    ASSERT_EQ(a.scans[i].T_map_base, b.scans[i].T_map_base) << i;
  }
}

TEST(MappingSession, GivesWhatMapLogGives) {
  RoomLog log;
  RoomLog same;
  MappingSession session("room", {}, {}, {});
  const MappedLog live = session.run(log);
  const MappedLog mapped = map_log(same, "room");
  expect_same_trajectory(live.map, mapped.map);
  EXPECT_EQ(live.name, mapped.name);
  EXPECT_EQ(live.format, mapped.format);
  EXPECT_EQ(live.sensor, mapped.sensor);
  EXPECT_EQ(live.scanner_names, mapped.scanner_names);
  EXPECT_EQ(live.findings.size(), mapped.findings.size());
}

TEST(MappingSession, TellsAPoseForEachScan) {
  RoomLog log;
  std::vector<Timestamp> stamps;
  MappingSession session(
      "room", {}, {}, {.on_pose = [&](const LogRecord& record, const LivePose& pose) {
        EXPECT_EQ(pose.stamp, record.stamp);
        stamps.push_back(pose.stamp);
      }});
  (void)session.run(log);
  EXPECT_EQ(stamps.size(), log.num_scans());
}

TEST(MappingSession, WhilePausedPosesGoOnByTheWheelsAndTheMapDoesNotGrow) {
  MappingSession* running = nullptr;
  RoomLog log([&](std::size_t scan) {
    if (scan == 40) running->pause(true);
    if (scan == 60) running->pause(false);
  });
  std::vector<Pose2> T_map_base;
  MappingSession session("room", {}, {}, {.on_pose = [&](const LogRecord&, const LivePose& pose) {
                           T_map_base.push_back(pose.T_map_base);
                         }});
  running = &session;
  const MappedLog mapped = session.run(log);
  EXPECT_EQ(mapped.map.scans.size(), log.num_scans() - 20);
  ASSERT_EQ(T_map_base.size(), log.num_scans());
  for (std::size_t i = 41; i < 60; ++i) {
    const Pose2 told = T_map_base[40].inverse() * T_map_base[i];
    const Pose2 truth = log.truth()[40].inverse() * log.truth()[i];
    EXPECT_NEAR(told.x_m, truth.x_m, 1e-9) << i;
    EXPECT_NEAR(told.y_m, truth.y_m, 1e-9) << i;
  }
}

TEST(MappingSession, AResetForgetsAll) {
  MappingSession* running = nullptr;
  RoomLog log([&](std::size_t scan) {
    if (scan == 50) running->reset();
  });
  int num_resets = 0;
  MappingSession session("room", {}, {}, {.on_reset = [&] { ++num_resets; }});
  running = &session;
  const MappedLog mapped = session.run(log);
  EXPECT_EQ(mapped.map.scans.size(), log.num_scans() - 50);
  EXPECT_EQ(num_resets, 1);
}

TEST(MappingSession, AMapCanBeHadOnTheWay) {
  MappingSession* running = nullptr;
  std::future<LiveMapPtr> wanted;
  RoomLog log([&](std::size_t scan) {
    if (scan == 50) wanted = running->request_map();
  });
  MappingSession session("room", {}, {}, {});
  running = &session;
  (void)session.run(log);
  const LiveMapPtr map = wanted.get();
  ASSERT_NE(map, nullptr);
  EXPECT_GE(map->map.scans.size(), 50U);
}

/// A map of the room, and a log of it from elsewhere: a robot that begins anywhere.
class ContinuedRoom : public ::testing::Test {
 protected:
  void SetUp() override {
    RoomLog log;
    options_.known_map = std::make_shared<const Map>(map_log(log, "room").map);
    options_.known_map_name = "room";
    params_.map_period_s = 1000.0;  // Maps are drawn where they are asked for.
  }

  static RoomLog other_log(std::function<void(std::size_t)> before = {}) {
    return RoomLog(std::move(before),
                   {{6.5, 3.5}, {1.5, 3.5}, {1.5, 7.5}, {2.0, 1.5}, {6.5, 1.5}, {6.5, 3.5}});
  }

  MapLogOptions options_;
  LiveMapperParams params_;
};

TEST_F(ContinuedRoom, GivesWhatMapLogGives) {
  RoomLog log = other_log();
  RoomLog same = other_log();
  MappingSession session("other", options_, params_, {});
  const MappedLog live = session.run(log);
  const MappedLog mapped = map_log(same, "other", options_);
  ASSERT_EQ(live.map.sessions.size(), 2U);
  ASSERT_TRUE(is_joined(live.map, live.map.sessions.back()));
  expect_same_trajectory(live.map, mapped.map);
}

TEST_F(ContinuedRoom, PosesHaveAMeaningOnceThePlaceInTheMapIsFound) {
  MappingSession* running = nullptr;
  // A map on the way is waited for, so that what is known does not depend on the clock.
  RoomLog log = other_log([&](std::size_t scan) {
    if (scan % 60 == 59) (void)running->request_map().get();
  });
  std::vector<LivePose> poses;
  MappingSession session(
      "other", options_, params_, {.on_pose = [&](const LogRecord&, const LivePose& pose) {
        poses.push_back(pose);
      }});
  running = &session;
  EXPECT_EQ(session.report().warnings.size(), 1U);
  const Map map = session.run(log).map;
  EXPECT_FALSE(poses.front().is_placed);
  EXPECT_TRUE(poses.back().is_placed);
  EXPECT_TRUE(session.report().warnings.empty());
  const std::size_t first = map.scans.size() - poses.size();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!poses[i].is_placed) {
      EXPECT_TRUE(i == 0 || !poses[i - 1].is_placed) << i;  // What is found stays found.
      continue;
    }
    const Pose2 finished = map.scans[first + i].T_map_base;
    EXPECT_LT((poses[i].T_map_base.translation() - finished.translation()).norm(), 0.1) << i;
  }
}

TEST_F(ContinuedRoom, TheMapIsShownBeforeTheFirstScan) {
  MappingSession session("other", options_, params_, {});
  const LiveMapPtr map = session.request_map().get();
  ASSERT_NE(map, nullptr);
  EXPECT_EQ(map->map.scans.size(), options_.known_map->scans.size());
}

TEST_F(ContinuedRoom, AResetGoesBackToTheMap) {
  MappingSession* running = nullptr;
  RoomLog log = other_log([&](std::size_t scan) {
    if (scan == 30) running->reset();
  });
  MappingSession session("other", options_, params_, {});
  running = &session;
  const MappedLog mapped = session.run(log);
  EXPECT_EQ(mapped.map.scans.size(), options_.known_map->scans.size() + log.num_scans() - 30);
}

TEST(MappingSession, APoseThatIsSaidHasNoMeaning) {
  MappingSession session("room", {}, {}, {});
  EXPECT_FALSE(session.set_pose({1.0, 2.0, 0.0}));
}

TEST(MappingSession, HasTheDefaultPresetAlone) {
  MapLogOptions options;
  options.preset = Preset::kPaper;
  EXPECT_THROW(MappingSession("room", options, {}, {}), ParameterError);
}

}  // namespace mapping_session_test
}  // namespace setsquare
