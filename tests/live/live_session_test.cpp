// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/live/live_session.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "setsquare/core/error.hpp"
#include "tests/support/simulated_drive.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare {
namespace live_session_test {

/// Scans around the room with the wheels' truth; `before` is called before each.
class RoomLog final : public LogReader {
 public:
  explicit RoomLog(std::function<void(std::size_t)> before = {})
      : truth_(testing::drive(testing::way_around_the_room(), 0.1, rad_from_deg(6.0))),
        scans_(testing::scans_on_drive(testing::l_shaped_room(), truth_, 0.01)),
        before_(std::move(before)) {}

  const LogRecord* next() override {
    if (num_read_ == scans_.size()) return nullptr;
    if (before_) before_(num_read_);
    record_.sensor = "LASER";
    record_.scan = scans_[num_read_];
    record_.stamp = record_.scan.stamp;
    record_.T_odom_base = truth_[num_read_++];
    return &record_;
  }
  [[nodiscard]] const LogProblems& problems() const override { return problems_; }
  [[nodiscard]] std::string front_sensor() const override { return "LASER"; }
  [[nodiscard]] std::string format() const override { return "room"; }
  [[nodiscard]] std::optional<double> fraction_read() const override { return std::nullopt; }
  [[nodiscard]] std::size_t num_scans() const { return scans_.size(); }
  [[nodiscard]] const std::vector<Pose2>& truth() const { return truth_; }

 private:
  std::vector<Pose2> truth_;
  std::vector<Scan> scans_;
  std::function<void(std::size_t)> before_;
  std::size_t num_read_ = 0;
  LogRecord record_;
  LogProblems problems_;
};

void expect_same_trajectory(const Map& a, const Map& b) {
  ASSERT_EQ(a.scans.size(), b.scans.size());
  for (std::size_t i = 0; i < a.scans.size(); ++i) {
    ASSERT_EQ(a.scans[i].T_map_base, b.scans[i].T_map_base) << i;
  }
}

TEST(LiveSession, GivesWhatMapLogGives) {
  RoomLog log;
  RoomLog same;
  LiveSession session("room", {}, {}, {});
  const MappedLog live = session.run(log);
  const MappedLog mapped = map_log(same, "room");
  expect_same_trajectory(live.map, mapped.map);
  EXPECT_EQ(live.name, mapped.name);
  EXPECT_EQ(live.format, mapped.format);
  EXPECT_EQ(live.sensor, mapped.sensor);
  EXPECT_EQ(live.scanner_names, mapped.scanner_names);
  EXPECT_EQ(live.findings.size(), mapped.findings.size());
}

TEST(LiveSession, TellsAPoseForEachScan) {
  RoomLog log;
  std::vector<Timestamp> stamps;
  LiveSession session(
      "room", {}, {}, {.on_pose = [&](const LogRecord& record, const LivePose& pose) {
        EXPECT_EQ(pose.stamp, record.stamp);
        stamps.push_back(pose.stamp);
      }});
  (void)session.run(log);
  EXPECT_EQ(stamps.size(), log.num_scans());
}

TEST(LiveSession, WhilePausedPosesGoOnByTheWheelsAndTheMapDoesNotGrow) {
  LiveSession* running = nullptr;
  RoomLog log([&](std::size_t scan) {
    if (scan == 40) running->pause(true);
    if (scan == 60) running->pause(false);
  });
  std::vector<Pose2> T_map_base;
  LiveSession session("room", {}, {}, {.on_pose = [&](const LogRecord&, const LivePose& pose) {
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

TEST(LiveSession, AResetForgetsAll) {
  LiveSession* running = nullptr;
  RoomLog log([&](std::size_t scan) {
    if (scan == 50) running->reset();
  });
  int num_resets = 0;
  LiveSession session("room", {}, {}, {.on_reset = [&] { ++num_resets; }});
  running = &session;
  const MappedLog mapped = session.run(log);
  EXPECT_EQ(mapped.map.scans.size(), log.num_scans() - 50);
  EXPECT_EQ(num_resets, 1);
}

TEST(LiveSession, AMapCanBeHadOnTheWay) {
  LiveSession* running = nullptr;
  std::future<LiveMapPtr> wanted;
  RoomLog log([&](std::size_t scan) {
    if (scan == 50) wanted = running->request_map();
  });
  LiveSession session("room", {}, {}, {});
  running = &session;
  (void)session.run(log);
  const LiveMapPtr map = wanted.get();
  ASSERT_NE(map, nullptr);
  EXPECT_GE(map->map.scans.size(), 50U);
}

TEST(LiveSession, HasTheDefaultPresetAlone) {
  MapLogOptions options;
  options.preset = Preset::kPaper;
  EXPECT_THROW(LiveSession("room", options, {}, {}), ParameterError);
}

}  // namespace live_session_test
}  // namespace setsquare
