// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What the command must never do to a user's files: write onto its input, leave a part of its
// outputs, or find after the work that it cannot write them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>

#include "tests/integration/run_setsquare.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare::cli_safe_outputs_test {

namespace fs = std::filesystem;
using testing::CommandOutcome;
using testing::content_of;
using ::testing::HasSubstr;
using testing::run_setsquare;
using testing::TemporaryFolder;

const char* const kPlan =
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 6 4'>\n"
    "<rect width='6' height='4'/><polyline id='route' points='1,1 3,1'/></svg>\n";

std::string two_scans() {
  std::ostringstream log;
  for (int i = 0; i < 2; ++i) {
    const Scan scan = testing::scan_of_walls(testing::l_shaped_room(), {1.5 + 0.1 * i, 1.5, 0.0});
    log << "FLASER 180";
    for (const double range_m : scan.ranges_m) log << " " << std::min(range_m, 81.83);
    log << " 0 0 0 0 0 0 " << 10 + i << ".000000 h 0\n";
  }
  return log.str();
}

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

/// Contents of all files below a folder.
std::map<std::string, std::string> all_below(const fs::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) contents[entry.path().string()] = content_of(entry.path());
  }
  return contents;
}

/// Refused in one line that names the reason, and nothing has changed.
void expect_refused(const fs::path& folder,
                    const std::string& arguments,
                    const std::string& reason = "it is the file that is read") {
  const auto before = all_below(folder);
  const CommandOutcome outcome = run_setsquare(arguments);
  EXPECT_EQ(outcome.exit_code, 2) << arguments;
  EXPECT_EQ(outcome.out, "") << arguments;
  EXPECT_THAT(outcome.err, HasSubstr(reason)) << arguments;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_EQ(all_below(folder), before) << arguments;
}

TEST(CommandSafeOutputs, APlanIsNotOverwrittenByTheSimulationInIt) {
  const TemporaryFolder folder;
  const std::string plan = folder.write("plan.svg", kPlan);
  expect_refused(folder.path(), "simulate --plan " + plan + " -o " + quoted(folder.path()));
  fs::create_directory(folder.path() / "out");
  fs::create_hard_link(folder.path() / "plan.svg", folder.path() / "out" / "scans.clf");
  expect_refused(folder.path(), "simulate --plan " + plan + " -o " + quoted(folder.path() / "out"));
}

TEST(CommandSafeOutputs, TheImageOfAMapPlanIsNotOverwritten) {
  const TemporaryFolder folder;
  static_cast<void>(folder.write("plan.svg", "P2 2 2 255 0 0 0 0"));
  const std::string plan =
      folder.write("m.yaml", "image: plan.svg\nresolution: 1\norigin: [0, 0, 0]\n");
  expect_refused(folder.path(),
                 "simulate --plan " + plan + " --route '1,1 2,2' -o " + quoted(folder.path()));
}

TEST(CommandSafeOutputs, ALogIsNotOverwrittenByItsMap) {
  const TemporaryFolder folder;
  const std::string log = folder.write("trajectory.tum", two_scans());
  const std::string map = "map " + log + " -o ";
  expect_refused(folder.path(), map + quoted(folder.path()));
  expect_refused(folder.path(), "map - -o " + quoted(folder.path()) + " <" + log);
  const fs::path out = folder.path() / "out";
  fs::create_directory(out);
  fs::create_symlink(folder.path() / "trajectory.tum", out / "map.png");
  expect_refused(folder.path(), map + quoted(out));
  fs::remove(out / "map.png");
  fs::create_hard_link(folder.path() / "trajectory.tum", out / "run.json");
  expect_refused(folder.path(), map + quoted(out));
  // What a killed run kept aside would be removed.
  fs::remove(out / "run.json");
  fs::create_directory(out / ".setsquare-new");
  fs::rename(folder.path() / "trajectory.tum", out / ".setsquare-new" / "trajectory.tum");
  expect_refused(folder.path(),
                 "map " + quoted(out / ".setsquare-new" / "trajectory.tum") + " -o " + quoted(out));
}

TEST(CommandSafeOutputs, LogRelationsAndOverlapsAreNotOverwrittenByMatches) {
  const TemporaryFolder folder;
  const std::string log = folder.write("room.svg", two_scans());
  const std::string pairs = folder.write("x.relations", "10.0 11.0 0.1 0 0 0 0 0\n");
  const std::string overlap = folder.write("x.overlap", "10.0 11.0 0.5\n");
  for (const std::string& target : {log, pairs, overlap}) {
    expect_refused(folder.path(), "match " + log + " --pairs " + pairs + " -o " + target);
  }
  expect_refused(folder.path(), "explain " + log + " 0 1 -o " + log);
  expect_refused(folder.path(), "explain - 0 1 -o " + log + " <" + log);
  fs::create_symlink(folder.path() / "room.svg", folder.path() / "link.svg");
  expect_refused(folder.path(), "explain " + log + " 0 1 -o " + quoted(folder.path() / "link.svg"));
}

TEST(CommandSafeOutputs, AnOutputThatCannotBeWrittenIsFoundBeforeTheWork) {
  const TemporaryFolder folder;
  // Its damaged record would be reported on a second line if the log were read first.
  const std::string log = folder.write("room.clf", "FLASER 3 1 2\n" + two_scans());
  const std::string pairs = folder.write("x.relations", "10.0 11.0 0.1 0 0 0 0 0\n");
  const std::string absent = quoted(folder.path() / "absent" / "match.svg");
  fs::create_directory(folder.path() / "folder.svg");
  const std::string directory = quoted(folder.path() / "folder.svg");
  const std::string reason = "cannot be written: ";
  expect_refused(folder.path(), "explain " + log + " 0 1 -o " + absent, reason);
  expect_refused(folder.path(), "explain " + log + " 0 1 -o " + directory, reason);
  expect_refused(folder.path(), "match " + log + " --pairs " + pairs + " -o " + absent, reason);
  expect_refused(folder.path(), "match " + log + " --pairs " + pairs + " -o " + directory, reason);
  expect_refused(folder.path(), "simulate --every 5 -o " + log, "room.clf");
  expect_refused(folder.path(), "map " + log + " -o " + log, "room.clf");
}

TEST(CommandSafeOutputs, ASignalLeavesTheLastSetAsItWasAndNothingElse) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  ASSERT_EQ(run_setsquare("simulate --building corridor --every 2 -o " + quoted(out)).exit_code, 0);
  const auto before = all_below(out);
  const auto interrupted = [&](const std::string& signal, const fs::path& into) {
    return run_setsquare("--version; '" SETSQUARE_COMMAND "' simulate --rate 10 --speed 0.01 -o " +
                         quoted(into) + " & run=$!; i=0; while [ ! -d " +
                         quoted(into / ".setsquare-new") +
                         " ] && [ $i -lt 500 ]; do sleep 0.02; i=$((i + 1)); done; kill -" +
                         signal + " $run; wait $run; exit $?");
  };
  EXPECT_EQ(interrupted("TERM", out).exit_code, 128 + 15);
  EXPECT_EQ(all_below(out), before);
  EXPECT_FALSE(fs::exists(out / ".setsquare-new"));
  EXPECT_EQ(interrupted("HUP", folder.path() / "new").exit_code, 128 + 1);
  EXPECT_FALSE(fs::exists(folder.path() / "new")) << "the directory that it made is gone";
}

TEST(CommandSafeOutputs, AFileThatGrowsBeyondTheLimitIsAnErrorOfWriting) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  const CommandOutcome outcome = run_setsquare("--version; ulimit -f 8; '" SETSQUARE_COMMAND
                                               "' simulate --building corridor --every 2 -o " +
                                               quoted(out));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("scans.clf: cannot be written: "));
  EXPECT_FALSE(fs::exists(out));
}

TEST(CommandSafeOutputs, AnotherCommandsUnfinishedSetIsNotTouched) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  fs::create_directories(out / ".setsquare-whole");
  static_cast<void>(folder.write("out/.setsquare-whole/run.json", "{}"));
  expect_refused(folder.path(), "simulate --every 5 -o " + quoted(out), "another command");
}

}  // namespace setsquare::cli_safe_outputs_test
