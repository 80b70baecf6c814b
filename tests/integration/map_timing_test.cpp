// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "apps/setsquare/map/timing.hpp"

namespace setsquare::map_timing_test {

using app::MapTiming;
using app::StageClock;
using nlohmann::json;

void wait_ms(int duration_ms) {
  std::this_thread::sleep_for(std::chrono::milliseconds(duration_ms));
}

TEST(StageClock, AddsUpWhatEachStageTook) {
  StageClock clock;
  clock.end();
  EXPECT_TRUE(clock.stages().empty());
  clock.begin("track");
  wait_ms(20);
  clock.begin("grid");
  clock.begin("track");
  wait_ms(20);
  clock.end();
  wait_ms(50);
  clock.end();
  ASSERT_EQ(clock.stages().size(), 2U);
  EXPECT_EQ(clock.stages()[0].stage, "track");
  EXPECT_GE(clock.stages()[0].wall_s, 0.04);
  EXPECT_EQ(clock.stages()[1].stage, "grid");
  EXPECT_LT(clock.stages()[1].wall_s, 0.02);
}

TEST(MapTiming, StatesStagesMachineAndBuild) {
  const json timing = json::parse(app::timing_json(
      MapTiming{.stages = {{"track", 1.5}, {"grid", 0.25}}, .num_scans = 1000, .num_threads = 2}));
  EXPECT_EQ(timing["wall_s"]["stages"]["track"], 1.5);
  EXPECT_EQ(timing["wall_s"]["stages"]["grid"], 0.25);
  EXPECT_EQ(timing["wall_s"]["total"], 1.75);
  EXPECT_EQ(timing["us_per_scan"], 1750.0);
  EXPECT_EQ(timing["scans"], 1000);
  EXPECT_EQ(timing["threads"], 2);
  EXPECT_FALSE(timing["machine"]["processor"].get<std::string>().empty());
  EXPECT_GE(timing["machine"]["cores"], 1);
  for (const char* const key : {"version", "compiler", "type"}) {
    EXPECT_FALSE(timing["build"][key].get<std::string>().empty()) << key;
  }
}

TEST(MapTiming, NoScanAndNoStageIsStillAFile) {
  const json timing = json::parse(app::timing_json({}));
  EXPECT_EQ(timing["us_per_scan"], 0.0);
  EXPECT_TRUE(timing["wall_s"]["stages"].is_object());
}

TEST(PeakMemory, GrowsWithWhatIsUsed) {
  const std::uint64_t before = app::peak_memory_bytes();
  EXPECT_GT(before, 1'000'000U);
  constexpr std::size_t kSize = 200'000'000;
  const std::vector<char> block(kSize, 'x');
  EXPECT_GE(app::peak_memory_bytes(), kSize);
  EXPECT_LT(app::peak_memory_bytes(), before + 2 * kSize) << "bytes, not kilobytes or pages";
  EXPECT_EQ(block.back(), 'x');
}

}  // namespace setsquare::map_timing_test
