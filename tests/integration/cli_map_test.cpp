// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "tests/integration/run_setsquare.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare::cli_map_test {

using testing::CommandOutcome;
using testing::content_of;
using ::testing::HasSubstr;
using testing::run_setsquare;
using testing::TemporaryFolder;

/// A robot crosses a room; its laser sits 0.2 m before its middle. The second stamp runs backwards.
std::string room_log() {
  std::ostringstream log;
  for (int i = 0; i < 30; ++i) {
    const double x_m = 1.5 + 0.05 * i;
    const Scan scan = testing::scan_of_walls(testing::l_shaped_room(), {x_m + 0.2, 1.5, 0.0});
    log << "FLASER 180";
    for (const double range_m : scan.ranges_m) log << " " << std::min(range_m, 81.83);
    const double stamp_s = i == 1 ? 99.9 : 100.0 + 0.2 * i;
    log << " " << x_m + 0.2 << " 1.5 0 " << x_m << " 1.5 0 " << stamp_s << " h 0\n";
  }
  return log.str();
}

std::vector<std::string> lines_of(const std::filesystem::path& path) {
  std::istringstream text(content_of(path));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) {
    if (!line.empty() && line.front() != '#') lines.push_back(line);
  }
  return lines;
}

TEST(CommandMap, WritesEveryScansPoseInFileOrderAPictureAndTheRun) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "a" / "b";
  const CommandOutcome outcome =
      run_setsquare("map " + folder.write("room.clf", room_log()) + " -o '" + out.string() + "'");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto poses = lines_of(out / "trajectory.tum");
  ASSERT_EQ(poses.size(), 30U);
  EXPECT_EQ(poses[1].substr(0, 10), "99.900000 ") << "the log's own stamps, in its order";
  double first_x = 0.0, first_y = 0.0, x = 0.0, y = 0.0;
  ASSERT_EQ(std::sscanf(poses.front().c_str(), "%*f %lf %lf", &first_x, &first_y), 2);
  ASSERT_EQ(std::sscanf(poses.back().c_str(), "%*f %lf %lf", &x, &y), 2);
  EXPECT_NEAR(std::hypot(x - first_x, y - first_y), 29 * 0.05, 0.01);
  EXPECT_EQ(content_of(out / "map.png").substr(1, 3), "PNG");
  EXPECT_THAT(content_of(out / "run.json"), HasSubstr("\"scans\": 30"));
  EXPECT_THAT(content_of(out / "run.json"), HasSubstr("\"lost\": 0"));
}

TEST(CommandMap, WhereNoScanCanBeMappedTheLastMapStays) {
  const TemporaryFolder folder;
  const std::string log = folder.write("room.clf", room_log());
  const std::string command = "map " + log + " -o '" + (folder.path() / "out").string() + "'";
  ASSERT_EQ(run_setsquare(command).exit_code, 0);
  const std::string picture = content_of(folder.path() / "out" / "map.png");
  const CommandOutcome outcome = run_setsquare(command + " --max-range 0.1");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("none of its 30 scans could be mapped"));
  EXPECT_EQ(content_of(folder.path() / "out" / "map.png"), picture);
}

TEST(CommandMap, ListsTheFilesThatItWrote) {
  const TemporaryFolder folder;
  const std::string log = folder.write("room.clf", room_log());
  for (const std::string preset : {"default", "paper"}) {
    const auto out = folder.path() / preset;
    const CommandOutcome outcome =
        run_setsquare("map " + log + " -o '" + out.string() + "' --preset " + preset);
    ASSERT_EQ(outcome.exit_code, 0);
    const std::string told = outcome.out.substr(outcome.out.find("written: "));
    for (const auto& entry : std::filesystem::directory_iterator(out)) {
      EXPECT_THAT(told, HasSubstr(entry.path().filename().string()));
    }
    EXPECT_EQ(told.find("report.html") != std::string::npos,
              std::filesystem::exists(out / "report.html"));
  }
}

TEST(CommandMap, SameLogSameBytes) {
  const TemporaryFolder folder;
  const std::string log = folder.write("room.clf", room_log());
  for (const std::string name : {"one", "two"}) {
    ASSERT_EQ(
        run_setsquare("map " + log + " -o '" + (folder.path() / name).string() + "'").exit_code, 0);
  }
  for (const std::string name : {"trajectory.tum", "run.json", "map.png"}) {
    EXPECT_EQ(content_of(folder.path() / "one" / name), content_of(folder.path() / "two" / name));
  }
}

TEST(CommandMap, TheSensorsFrameIsTheMountingAway) {
  const TemporaryFolder folder;
  const std::string log = folder.write("room.clf", room_log());
  std::vector<double> x_m;
  for (const std::string frame : {"base", "sensor"}) {
    const auto out = folder.path() / frame;
    ASSERT_EQ(
        run_setsquare("map " + log + " --frame " + frame + " -o '" + out.string() + "'").exit_code,
        0);
    double x = 0.0, y = 0.0;
    ASSERT_EQ(std::sscanf(lines_of(out / "trajectory.tum").front().c_str(), "%*f %lf %lf", &x, &y),
              2);
    x_m.push_back(x);
  }
  EXPECT_NEAR(std::abs(x_m[1] - x_m[0]), 0.2, 0.01);
}

TEST(CommandMap, MapsWithoutOdometryAndByThePaper) {
  const TemporaryFolder folder;
  const std::string log = folder.write("room.clf", room_log());
  for (const std::string option : {"--no-odometry", "--preset paper"}) {
    const auto out = folder.path() / "out";
    const CommandOutcome outcome =
        run_setsquare("map " + log + " " + option + " -o '" + out.string() + "'");
    EXPECT_EQ(outcome.exit_code, 0) << option << outcome.err;
    EXPECT_THAT(content_of(out / "run.json"), HasSubstr("\"scans_with_odometry\": 0")) << option;
  }
}

TEST(CommandMap, ABadLogOrDirectoryLeavesNothingBehind) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "out";
  const std::string to_out = " -o '" + out.string() + "'";
  for (const std::string& log : {folder.write("empty.clf", ""),
                                 folder.write("no_scans.clf", "PARAM robot_length 1 1.0 h 1.0\n"),
                                 "'" + (folder.path() / "absent.clf").string() + "'"}) {
    const CommandOutcome outcome = run_setsquare("map " + log + to_out);
    EXPECT_EQ(outcome.exit_code, 2) << log;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(out)) << log;
  }
  for (const char* const ending : {"", "/"}) {
    const std::filesystem::path there = folder.path() / "there";
    std::filesystem::create_directory(there);
    const CommandOutcome outcome =
        run_setsquare("map '" + (folder.path() / "no_scans.clf").string() + "' -o '" +
                      (there / "r" / "s").string() + ending + "'");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(std::filesystem::is_empty(there)) << "the folders that it made are gone";
  }
  const std::string log = folder.write("room.clf", room_log());
  EXPECT_EQ(run_setsquare("map " + log + " -o " + log).exit_code, 2) << "a file is no directory";
}

}  // namespace setsquare::cli_map_test
