// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "setsquare/io/maps/map_pgm_yaml.hpp"
#include "tests/integration/run_setsquare.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare::cli_map_outputs_test {

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

/// The files of a folder, hidden or not, and what is in them.
std::map<std::string, std::string> contents_of(const fs::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) contents[entry.path().filename()] = content_of(entry.path());
  }
  return contents;
}

CommandOutcome map_into(const fs::path& out, const std::string& log) {
  return run_setsquare("map " + log + " -o '" + out.string() + "'");
}

TEST(CommandMapOutputs, TheMapFilesShowTheRoomAndLieAlongIt) {
  const TemporaryFolder folder;
  const CommandOutcome outcome =
      map_into(folder.path() / "out", folder.write("room.clf", room_log(30)));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const OccupancyGrid grid = read_map_pgm_yaml((folder.path() / "out" / "map.yaml").string());
  EXPECT_EQ(grid.T_map_grid().theta_rad, 0.0);
  EXPECT_EQ(grid.resolution_m(), 0.05);
  int num_free = 0;
  int longest_row = 0;
  for (CellIndex cell; cell.row < grid.num_rows(); ++cell.row) {
    int num_occupied = 0;
    for (cell.column = 0; cell.column < grid.num_columns(); ++cell.column) {
      num_free += grid.state(cell) == CellState::kFree;
      num_occupied += grid.state(cell) == CellState::kOccupied;
    }
    longest_row = std::max(longest_row, num_occupied);
  }
  EXPECT_GT(num_free * 0.05 * 0.05, 5.0) << "square metres";
  EXPECT_GT(longest_row * 0.05, 2.0) << "metres of wall in one row of cells";
}

TEST(CommandMapOutputs, TimesAndMachineStandInTimingJsonAlone) {
  const TemporaryFolder folder;
  const std::string log = folder.write("room.clf", room_log(30));
  ASSERT_EQ(map_into(folder.path() / "one", log).exit_code, 0);
  ASSERT_EQ(map_into(folder.path() / "two", log).exit_code, 0);
  auto one = contents_of(folder.path() / "one");
  auto two = contents_of(folder.path() / "two");
  EXPECT_THAT(one["timing.json"], HasSubstr("\"processor\""));
  EXPECT_THAT(one["timing.json"], HasSubstr("\"grid\""));
  one.erase("timing.json");
  two.erase("timing.json");
  EXPECT_EQ(one, two);
}

TEST(CommandMapOutputs, ARunKilledInItsMiddleLeavesTheLastOutputsWhole) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  ASSERT_EQ(map_into(out, folder.write("short.clf", room_log(20))).exit_code, 0);
  const auto before = contents_of(out);
  EXPECT_TRUE(before.contains("run.json"));

  // A log without end: the pipe stays open until the run has been killed.
  const std::string pipe = "'" + (folder.path() / "pipe").string() + "'";
  const std::string log = folder.write("long.clf", room_log(40));
  const CommandOutcome killed = run_setsquare(
      "--version; mkfifo " + pipe + "; '" SETSQUARE_COMMAND "' map - -o '" + out.string() + "' <" +
      pipe + " & run=$!; exec 3>" + pipe + "; for i in 1 2 3 4 5 6 7 8 9; do cat " + log +
      " >&3; done; sleep 0.3; kill -9 $run; wait $run; exit 7");
  EXPECT_EQ(killed.exit_code, 7) << killed.err;
  EXPECT_TRUE(fs::exists(out / ".setsquare-new")) << "it was killed while it worked";
  EXPECT_EQ(contents_of(out), before);

  ASSERT_EQ(map_into(out, log).exit_code, 0);
  EXPECT_FALSE(fs::exists(out / ".setsquare-new"));
  EXPECT_THAT(content_of(out / "run.json"), HasSubstr("\"scans\": 40"));
}

TEST(CommandMapOutputs, RunJsonNamesTheLogTheVersionAndTheOptions) {
  const TemporaryFolder folder;
  const std::string log = folder.write("B\xC3\xBCro_\xE6\x97\xA5\xE6\x9C\xAC.clf", room_log(20));
  const CommandOutcome outcome = run_setsquare("map " + log + " --max-range 40 --no-odometry -o '" +
                                               (folder.path() / "out").string() + "'");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto run = nlohmann::json::parse(content_of(folder.path() / "out" / "run.json"));
  EXPECT_EQ("'" + run["log"].get<std::string>() + "'", log);
  EXPECT_THAT(run_setsquare("--version").out, HasSubstr(run["version"].get<std::string>()));
  EXPECT_EQ(run["options"]["odometry"], false);
  EXPECT_EQ(run["options"]["max_range_m"], 40.0);
  EXPECT_TRUE(run["options"]["sensor"].is_null());
  const std::string not_utf8 = folder.write("B\xFCro.clf", room_log(20));
  ASSERT_EQ(map_into(folder.path() / "out", not_utf8).exit_code, 0);
  EXPECT_THAT(content_of(folder.path() / "out" / "run.json"), HasSubstr("B\xEF\xBF\xBDro.clf"));
}

}  // namespace setsquare::cli_map_outputs_test
