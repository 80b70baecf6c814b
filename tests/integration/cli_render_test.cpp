// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "tests/integration/run_setsquare.hpp"
#include "tests/support/data_dir.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare::cli_render_test {

namespace fs = std::filesystem;
using testing::CommandOutcome;
using testing::content_of;
using ::testing::HasSubstr;
using testing::run_setsquare;
using testing::TemporaryFolder;

/// A robot crosses a room in `num_scans` steps of 5 cm.
std::string room_log(int num_scans) {
  std::ostringstream log;
  for (int i = 0; i < num_scans; ++i) {
    const double x_m = 1.5 + 0.05 * i;
    const Scan scan = testing::scan_of_walls(testing::l_shaped_room(), {x_m, 1.5, 0.0});
    log << "FLASER 180";
    for (const double range_m : scan.ranges_m) log << " " << std::min(range_m, 81.83);
    for (int pose = 0; pose < 2; ++pose) log << " " << x_m << " 1.5 0";
    log << " " << 100.0 + 0.2 * i << " h 0\n";
  }
  return log.str();
}

/// All files below a folder, by their names in it.
std::map<std::string, std::string> files_below(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    files[fs::relative(entry.path(), folder).string()] = content_of(entry.path());
  }
  return files;
}

class CommandRender : public ::testing::Test {
 protected:
  /// Maps into DIR/out.
  void map(const std::string& log, const std::string& options = "") {
    const CommandOutcome outcome = run_setsquare("map " + log + " -o " + quoted("out") + options);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  void map_room() { map(folder_.write("room.clf", room_log(30))); }

  [[nodiscard]] fs::path path(const std::string& name) const { return folder_.path() / name; }
  [[nodiscard]] std::string quoted(const std::string& name) const {
    return "'" + path(name).string() + "'";
  }
  [[nodiscard]] CommandOutcome render(const std::string& map, const std::string& out) const {
    return run_setsquare("render " + quoted(map) + (out.empty() ? "" : " -o " + quoted(out)));
  }

  /// Renders DIR/out into DIR/again: all files must be those of `map`, but for the map itself and
  /// its times.
  void expect_same_again() const {
    const CommandOutcome outcome = render("out/map.setsquare", "again");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    auto mapped = files_below(path("out"));
    EXPECT_EQ(mapped.erase("map.setsquare"), 1U);
    EXPECT_EQ(mapped.erase("timing.json"), 1U);
    const auto rendered = files_below(path("again"));
    for (const auto& [name, bytes] : mapped) {
      ASSERT_TRUE(rendered.contains(name)) << name;
      EXPECT_TRUE(rendered.at(name) == bytes) << name << " is another";
    }
    EXPECT_EQ(rendered.size(), mapped.size());
  }

  TemporaryFolder folder_;
};

TEST_F(CommandRender, MakesEveryOtherOutputAgainByteForByte) {
  map_room();
  expect_same_again();
  for (const char* name : {"map.pgm",
                           "map.yaml",
                           "map.png",
                           "trajectory.tum",
                           "poses.tsv",
                           "graph.g2o",
                           "closures.tsv",
                           "report.html",
                           "run.json"}) {
    EXPECT_TRUE(fs::exists(path("again") / name)) << name;
  }
}

TEST_F(CommandRender, KeepsTheOptionsOfTheRun) {
  const std::string log = folder_.write("B\xC3\xBCro \xFC.clf", room_log(30));
  map(log, " --frame sensor --no-odometry --no-audit --max-range 40");
  expect_same_again();
  map(log, " --preset paper");
  fs::remove_all(path("again"));
  expect_same_again();
}

TEST_F(CommandRender, MakesTheOutputsOfARealLogAgain) {
  const auto log = testing::data_file("intel/intel.clf");
  if (!log) GTEST_SKIP() << "no real logs";
  map("'" + log->string() + "'", " --to 300");
  expect_same_again();
}

TEST_F(CommandRender, InItsOwnFolderRestoresWhatIsLostAndLeavesTheMap) {
  map_room();
  const auto before = files_below(path("out"));
  fs::remove(path("out/map.png"));
  std::ofstream(path("out/poses.tsv")) << "spoilt";
  const auto written = fs::last_write_time(path("out/map.setsquare"));
  ASSERT_EQ(render("out", "").exit_code, 0);
  EXPECT_EQ(files_below(path("out")), before);
  ASSERT_EQ(render("out/map.setsquare", "out").exit_code, 0);
  EXPECT_EQ(files_below(path("out")), before);
  EXPECT_EQ(fs::last_write_time(path("out/map.setsquare")), written);
}

TEST_F(CommandRender, LeavesTheFolderOfAnotherMapAsItIs) {
  map_room();
  fs::rename(path("out"), path("other"));
  map(folder_.write("short.clf", room_log(20)));
  const auto before = files_below(path("other"));
  const CommandOutcome outcome = render("out", "other");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("is another map, with its own outputs"));
  EXPECT_EQ(files_below(path("other")), before);
}

TEST_F(CommandRender, ALinkToTheMapIsTheMap) {
  map_room();
  fs::create_directory(path("links"));
  fs::create_symlink(path("out/map.setsquare"), path("links/run.json"));
  const std::string map = content_of(path("out/map.setsquare"));
  const CommandOutcome outcome = render("out", "links");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("it is the file that is read"));
  EXPECT_EQ(content_of(path("out/map.setsquare")), map);
  EXPECT_TRUE(fs::is_symlink(path("links/run.json")));
}

TEST_F(CommandRender, WhatIsNoMapOrDamagedIsSaidInOneLineAndNothingIsWritten) {
  map_room();
  std::string bytes = content_of(path("out/map.setsquare"));
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
  static_cast<void>(folder_.write("damaged", bytes));
  static_cast<void>(folder_.write("room.clf", room_log(3)));
  const std::pair<const char*, const char*> cases[] = {{"damaged", "is damaged (section "},
                                                       {"room.clf", "is no map of Setsquare"},
                                                       {"absent", "absent"},
                                                       {".", "map.setsquare"}};
  for (const auto& [name, reason] : cases) {
    const CommandOutcome outcome = render(name, "new");
    EXPECT_EQ(outcome.exit_code, 2) << name;
    EXPECT_THAT(outcome.err, HasSubstr(reason)) << name;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    EXPECT_FALSE(fs::exists(path("new"))) << name;
  }
}

TEST_F(CommandRender, InfoSaysWhatIsInAMap) {
  map_room();
  for (const char* name : {"out", "out/map.setsquare"}) {
    const CommandOutcome outcome = run_setsquare("info " + quoted(name));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("a map of Setsquare"));
    EXPECT_THAT(outcome.out, HasSubstr("room.clf"));
    EXPECT_THAT(outcome.out, HasSubstr("scans      30, stamps 100.000000 to 105.800000"));
  }
  const auto json = nlohmann::json::parse(run_setsquare("info --json " + quoted("out")).out);
  EXPECT_EQ(json.at("kind"), "map");
  EXPECT_EQ(json.at("scans"), 30);
  EXPECT_EQ(json.at("bytes"), fs::file_size(path("out/map.setsquare")));
}

}  // namespace setsquare::cli_render_test
