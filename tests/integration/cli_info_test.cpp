// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/integration/run_setsquare.hpp"
#include "tests/support/data_dir.hpp"

namespace setsquare::cli_info_test {

using testing::CommandOutcome;
using ::testing::HasSubstr;
using testing::run_setsquare;
using testing::TemporaryFolder;

/// Three scans a second apart; the third stamp runs backwards, the wheels contradict the pose.
std::string small_log() {
  return "FLASER 4 1.00 2.00 3.00 81.83 0 0 0 0 0 0 100.0 h 0\n"
         "ODOM 0.0 0 0 -0.2 0 0 100.1 h 0\n"
         "ODOM 0.1 0 0 -0.2 0 0 100.6 h 0\n"
         "FLASER 4 1.00 2.00 3.00 0.00 0.1 0 0 0.1 0 0 101.0 h 0\n"
         "FLASER 4 1.00 2.00 x\n"
         "FLASER 4 1.00 2.00 3.00 4.00 0.2 0 0 0.2 0 0 100.5 h 0\n";
}

TEST(CommandInfo, ReportsTheContentsOfALogAndItsFaults) {
  const TemporaryFolder folder;
  const CommandOutcome outcome = run_setsquare("info " + folder.write("small.clf", small_log()));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  for (const char* expected : {"small.clf: CARMEN log",
                               "FLASER",
                               "3 in 1.0 s",
                               "81.83 m (1)",
                               "path 0.2 m",
                               "1 stamps run backwards, by up to 0.50 s",
                               "contradicts itself in 1 of 2 steps",
                               "1 damaged record skipped",
                               "line 5: FLASER: ranges missing"}) {
    EXPECT_THAT(outcome.out, HasSubstr(expected));
  }
}

TEST(CommandInfo, JsonForMachines) {
  const TemporaryFolder folder;
  const CommandOutcome outcome =
      run_setsquare("info --json " + folder.write("small.clf", small_log()));
  EXPECT_EQ(outcome.exit_code, 0);
  for (const char* expected : {R"("num_scans": 3)",
                               R"("num_backward": 1)",
                               R"("num_no_returns": 1)",
                               R"("num_invalid": 1)",
                               R"("num_damaged": 1)",
                               R"("location": "line 5")"}) {
    EXPECT_THAT(outcome.out, HasSubstr(expected));
  }
}

TEST(CommandInfo, StandardInputPlainAndPacked) {
  const TemporaryFolder folder;
  const std::string log = folder.write("small.clf", small_log());
  const CommandOutcome plain = run_setsquare("info - <" + log);
  const CommandOutcome packed =
      run_setsquare("--version >/dev/null; gzip -c " + log + " | '" SETSQUARE_COMMAND "' info -");
  EXPECT_THAT(plain.out, HasSubstr("standard input: CARMEN log"));
  EXPECT_EQ(packed.out, plain.out);
}

TEST(CommandInfo, FindsWhatIsWrongWithRealLogs) {
  const auto intel = testing::data_file("intel/intel.clf");
  const auto fr079 = testing::data_file("fr079/fr079.clf");
  if (!intel || !fr079) GTEST_SKIP() << "no data folder";
  EXPECT_THAT(run_setsquare("info '" + intel->string() + "'").out,
              HasSubstr("631 stamps run backwards"));
  EXPECT_THAT(run_setsquare("info '" + fr079->string() + "'").out,
              HasSubstr("contradicts itself in 322 of 8951 steps"));
}

// A trajectory 0.1 m and 0.1 rad off in its second pose, and one relation it cannot answer.
TEST(CommandEvaluate, RelationsAsTableAndJson) {
  const TemporaryFolder folder;
  const std::string files =
      folder.write("t.tum", "1.0 0 0 0 0 0 0 1\n2.0 1.1 0 0 0 0 0.0499791693 0.9987502604\n") +
      " " + folder.write("x.relations", "1.0 2.0 1 0 0 0 0 0\n1.0 9.0 1 0 0 0 0 0\n");
  const CommandOutcome table = run_setsquare("evaluate relations " + files);
  EXPECT_EQ(table.exit_code, 0) << table.err;
  EXPECT_THAT(table.out, HasSubstr("1 relations are left out"));
  EXPECT_THAT(table.out, HasSubstr("5.730"));
  const CommandOutcome json = run_setsquare("evaluate relations --json " + files);
  EXPECT_THAT(json.out, HasSubstr(R"("num_missing": 1)"));
  EXPECT_THAT(json.out, HasSubstr(R"("num_relations": 1)"));
}

}  // namespace setsquare::cli_info_test
