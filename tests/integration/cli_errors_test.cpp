// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The command's answer to bad input: one line that names the file and the reason, exit code 2.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/integration/run_setsquare.hpp"

namespace setsquare::cli_errors_test {

using testing::CommandOutcome;
using ::testing::HasSubstr;
using ::testing::Not;
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
  expect_one_line_error("info", "log is required");
  expect_one_line_error("info --no-such-option x", "--no-such-option");
  expect_one_line_error("info x --max-range far", "--max-range");
}

TEST(CommandErrors, WithoutACommandTheCommandsAreListed) {
  for (const char* const arguments : {"", "evaluate"}) {
    const CommandOutcome outcome = run_setsquare(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, StartsWith("Usage: setsquare"));
    EXPECT_THAT(outcome.err, HasSubstr("--help"));
  }
  for (const char* const name :
       {"info", "map", "merge", "render", "match", "explain", "simulate", "evaluate"}) {
    EXPECT_THAT(run_setsquare("").err, HasSubstr(std::string("\n  ") + name + " "));
  }
}

TEST(CommandErrors, UnknownWordsAreNamedWithTheNearestOne) {
  expect_one_line_error("mpa x.clf -o out", "unknown command 'mpa' (did you mean 'map'?)");
  expect_one_line_error("evaluate relation a b", "(did you mean 'relations'?)");
  expect_one_line_error("frobnicate", "unknown command 'frobnicate'; see");
  expect_one_line_error("map x.clf -o out --thread 2",
                        "unknown option '--thread' (did you mean '--threads'?)");
  expect_one_line_error("--versoin", "unknown option '--versoin' (did you mean '--version'?)");
  expect_one_line_error("info a.clf b.clf", "unexpected argument 'b.clf'");
}

TEST(CommandErrors, ValuesOutOfTheirDomainNameTheOptionAndTheDomain) {
  expect_one_line_error("map x.clf -o out --preset foo", "'foo' is none of default, paper");
  expect_one_line_error("info x.clf --max-range -3", "--max-range: -3 is not a number above 0");
  expect_one_line_error("info x.clf --field-of-view 400", "above 0 and at most 360");
  expect_one_line_error("info x.clf --angular-step 0", "from -360 to 360 other than 0");
  expect_one_line_error("map x.clf -o out --threads 0", "a whole number from 1 to 1024");
  expect_one_line_error("simulate -o out --seed 99999999999999999999",
                        "--seed: 99999999999999999999 is not a whole number from 0 to");
  expect_one_line_error("simulate -o out --seed 1.5", "--seed: 1.5 is not a whole number");
  expect_one_line_error("simulate -o out --scanner big", "'big' is none of utm-30lx, low-cost-360");
  expect_one_line_error("evaluate ate a b --align middle", "'middle' is none of best, first, none");
}

TEST(CommandErrors, FilesThatAreNoLogs) {
  const TemporaryFolder folder;
  expect_one_line_error("info /no/such.clf", "/no/such.clf: No such file or directory");
  expect_one_line_error("info /", "/: a folder without a recording");
  expect_one_line_error("info " + folder.write("empty.clf", ""), "empty.clf: the file is empty");
  expect_one_line_error("info " + folder.write("text.clf", "no log\nat all\n"),
                        "text.clf: neither a ROS bag, a CARMEN log, JSON lines, a CSV table of "
                        "scans nor an MRPT rawlog");
  expect_one_line_error("info " + folder.write("a.bag", "#ROSBAG V2.0\n..."),
                        "a.bag: no scan in this log");
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
  for (const char* const arguments : {"--help >/dev/full", "map --help >/dev/full"}) {
    const CommandOutcome help = run_setsquare(arguments);
    EXPECT_EQ(help.exit_code, 2) << arguments;
    EXPECT_THAT(help.err, HasSubstr("standard output: cannot be written"));
  }
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

TEST(CommandHelp, ShowsDefaultsAndItsOwnExamplesAlone) {
  for (const std::string command : {"info",
                                    "map",
                                    "match",
                                    "explain",
                                    "simulate",
                                    "evaluate",
                                    "evaluate relations",
                                    "evaluate ate",
                                    "evaluate rpe",
                                    "evaluate closures",
                                    "evaluate chains"}) {
    const std::string help = run_setsquare(command + " --help").out;
    EXPECT_THAT(help, HasSubstr("Examples:\n  ")) << command;
    EXPECT_THAT(help, HasSubstr("setsquare " + command)) << command;
    for (const char* const odd : {"{false}", "(0x)", "[0", "UINT", "FLOAT", "Excludes", "[]"}) {
      EXPECT_THAT(help, Not(HasSubstr(odd))) << command;
    }
    if (command.find(' ') == std::string::npos && command != "info") {
      EXPECT_THAT(help, Not(HasSubstr("setsquare info"))) << command;
    }
  }
  const std::string simulate = run_setsquare("simulate --help").out;
  for (const char* const text : {"(default: office)", "(default: 1)", "(default: 0.5)", "M/S"}) {
    EXPECT_THAT(simulate, HasSubstr(text));
  }
  EXPECT_THAT(run_setsquare("map --help").out, HasSubstr("(default: one per processor)"));
  EXPECT_THAT(run_setsquare("match --help").out, HasSubstr("(default: base)"));
}

}  // namespace setsquare::cli_errors_test
