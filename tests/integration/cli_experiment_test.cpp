// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

#include "tests/integration/run_setsquare.hpp"

namespace setsquare::cli_experiment_test {

using testing::CommandOutcome;
using testing::content_of;
using ::testing::HasSubstr;
using testing::run_setsquare;
using testing::TemporaryFolder;

/// A file without its times.
std::string without_timing(const std::filesystem::path& path) {
  const std::string text = content_of(path);
  return text.substr(0, text.find("\"timing\""));
}

TEST(CommandExperiment, WritesThePageAndTheSameNumbersForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const auto run = [&](const std::string& name, const std::string& options) {
    const auto out = folder.path() / name;
    const CommandOutcome outcome = run_setsquare("experiment paper --quick --only honesty -o '" +
                                                 out.string() + "' " + options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("paper.html"));
    EXPECT_THAT(outcome.out, HasSubstr("bare corridor"));
    EXPECT_THAT(outcome.out, HasSubstr("wrong matched"));
    EXPECT_THAT(content_of(out / "paper.html"), HasSubstr("\"world\": \"bare corridor\""));
    return without_timing(out / "paper.json");
  };
  const std::string alone = run("a/b", "--threads 1");
  EXPECT_THAT(alone, HasSubstr("\"bare corridor\""));
  EXPECT_EQ(run("c", "--threads 3"), alone);
}

TEST(CommandExperiment, RefusesASectionThatThereIsNot) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "out";
  const CommandOutcome outcome =
      run_setsquare("experiment paper --only section_6 -o '" + out.string() + "'");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("section_6"));
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(CommandExperiment, ReportsWhereItCannotWrite) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "");
  const CommandOutcome outcome = run_setsquare("experiment paper --only honesty -o " + file);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("file"));
}

TEST(CommandExperiment, HelpComesFromTheProgramThatOwnsTheOptions) {
  const CommandOutcome outcome = run_setsquare("experiment paper --help");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("--check-goals"));
  EXPECT_EQ(run_setsquare("experiment --help").exit_code, 0);
}

/// The command without the program in its folder: a copy in a separate folder.
TEST(CommandExperiment, WithoutItsProgramTheCommandSaysWhatToBuild) {
  const TemporaryFolder folder;
  const auto command = folder.path() / "setsquare";
  std::filesystem::copy_file(SETSQUARE_COMMAND, command);
  const auto run = [&](const std::string& options) {
    const auto out = (folder.path() / "out.txt").string();
    const int status = std::system(
        ("PATH=/nowhere '" + command.string() + "' experiment " + options + " >'" + out + "' 2>&1")
            .c_str());
    return std::pair(WEXITSTATUS(status), content_of(out));
  };
  const auto [exit_code, words] = run("paper -o " + (folder.path() / "out").string());
  EXPECT_EQ(exit_code, 2);
  EXPECT_THAT(words, HasSubstr("setsquare_experiment"));
  const auto [help_code, help] = run("--help");
  EXPECT_EQ(help_code, 0);
  EXPECT_THAT(help, HasSubstr("setsquare_experiment"));
}

}  // namespace setsquare::cli_experiment_test
