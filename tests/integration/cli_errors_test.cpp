// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What the command says to bad input: one line that names the file and the reason, exit code 2.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/integration/run_setsquare.hpp"

namespace setsquare {
namespace {

using testing::CommandOutcome;
using ::testing::HasSubstr;
using testing::run_setsquare;
using ::testing::StartsWith;
using testing::TemporaryFolder;

void expect_one_line_error(const std::string& arguments, const std::string& expected) {
  const CommandOutcome outcome = run_setsquare(arguments);
  EXPECT_EQ(outcome.exit_code, 2) << arguments;
  EXPECT_EQ(outcome.out, "") << arguments;
  EXPECT_THAT(outcome.err, StartsWith("setsquare: ")) << arguments;
  EXPECT_THAT(outcome.err, HasSubstr(expected)) << arguments;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST(CommandErrors, Usage) {
  expect_one_line_error("", "subcommand");
  expect_one_line_error("info", "log is required");
  expect_one_line_error("info --no-such-option x", "--no-such-option");
  expect_one_line_error("info x --max-range far", "--max-range");
  expect_one_line_error("evaluate", "subcommand");
}

TEST(CommandErrors, FilesThatAreNoLogs) {
  const TemporaryFolder folder;
  expect_one_line_error("info /no/such.clf", "/no/such.clf: No such file or directory");
  expect_one_line_error("info /", "/: Is a directory");
  expect_one_line_error("info " + folder.write("empty.clf", ""), "empty.clf: the file is empty");
  expect_one_line_error("info " + folder.write("text.clf", "no log\nat all\n"),
                        "text.clf: neither a CARMEN log nor an MRPT rawlog");
  expect_one_line_error("info " + folder.write("a.bag", "#ROSBAG V2.0\n..."), "a ROS 1 bag");
  std::string garbage;
  for (int i = 0; i < 100'000; ++i) garbage += static_cast<char>((i * 7919 + i / 13) % 251 - 125);
  expect_one_line_error("info " + folder.write("garbage", garbage), "garbage: neither");
  expect_one_line_error("info " + folder.write("a.gz", "\x1f\x8bgarbage"), "gzip stream");
  expect_one_line_error("info -", "standard input: the file is empty");
}

TEST(CommandErrors, ALogWithoutScans) {
  const TemporaryFolder folder;
  expect_one_line_error("info " + folder.write("x.clf", "ODOM 0 0 0 0 0 0 1.0 h 0\n"),
                        "x.clf: no scan in this log");
}

TEST(CommandErrors, OutputThatCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string log = folder.write("x.clf", "FLASER 2 1 2 0 0 0 0 0 0 1.0 h 0\n");
  const CommandOutcome outcome = run_setsquare("info " + log + " >/dev/full");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("standard output: cannot be written"));
}

TEST(CommandErrors, GroundTruthThatIsNone) {
  const TemporaryFolder folder;
  const std::string trajectory = folder.write("t.tum", "1.0 0 0 0 0 0 0 1\n2.0 1 0 0 0 0 0 1\n");
  const std::string relations = folder.write("x.relations", "1.0 2.0 1 0 0 0 0 0\n1.0 2.0 1\n");
  const std::string others = folder.write("o.relations", "7.0 8.0 1 0 0 0 0 0\n");
  expect_one_line_error("evaluate relations " + trajectory + " " + relations,
                        "x.relations, line 2: expected");
  expect_one_line_error("evaluate relations " + relations + " " + relations,
                        "x.relations, stamp 1.000000: qx qy qz qw are no rotation");
  expect_one_line_error("evaluate relations " + trajectory + " " + others,
                        "no relation has both its stamps in");
}

TEST(CommandHelp, GoesToStandardOutputWithExamples) {
  for (const char* arguments : {"--help", "info --help", "evaluate relations --help"}) {
    const CommandOutcome outcome = run_setsquare(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << arguments;
    EXPECT_THAT(outcome.out, HasSubstr("Example")) << arguments;
    EXPECT_EQ(outcome.err, "") << arguments;
  }
  EXPECT_THAT(run_setsquare("--version").out, StartsWith("setsquare "));
}

}  // namespace
}  // namespace setsquare
