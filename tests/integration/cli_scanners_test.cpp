// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `simulate` and `map` of a robot with two scanners, one ahead to the left and one behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/integration/run_setsquare.hpp"

namespace setsquare::cli_scanners_test {

using testing::CommandOutcome;
using testing::content_of;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::run_setsquare;
using testing::TemporaryFolder;

class TwoScanners : public ::testing::Test {
 protected:
  /// The log of a short drive; `options`: further ones of `simulate`.
  std::string simulate(const std::string& options = "") {
    const CommandOutcome outcome = run_setsquare(
        "simulate --building hallway --beams 271 --every 0.15 --every-angle 6 "
        "--mounting 0.25,0.2,45 --mounting -0.25,-0.2,-135 " +
        options + " -o '" + path("sim") + "'");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return path("sim") + "/scans.clf";
  }

  CommandOutcome map(const std::string& logs, const std::string& options, const std::string& name) {
    return run_setsquare("map " + logs + " " + options + " -o '" + path(name) + "'");
  }

  [[nodiscard]] std::string trajectory(const std::string& name) const {
    return content_of(path(name) + "/trajectory.tum");
  }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  TemporaryFolder folder_;
};

/// Between two texts; empty where they are not there.
std::string between(const std::string& text, const std::string& before, const std::string& behind) {
  const std::size_t begin = text.find(before);
  if (begin == std::string::npos) return {};
  const std::size_t end = text.find(behind, begin + before.size());
  return text.substr(begin + before.size(), end - begin - before.size());
}

TEST_F(TwoScanners, AreMappedTogetherWhereBothAreAsked) {
  const std::string log = simulate();
  const CommandOutcome front = map(log, "", "front");
  EXPECT_THAT(front.out, Not(HasSubstr("sensor")));
  const CommandOutcome both = map(log, "--sensor all", "both");
  EXPECT_THAT(both.out, HasSubstr("sensor ROBOTLASER1: leads"));
  EXPECT_THAT(both.out, HasSubstr("sensor ROBOTLASER2: its mounting fits"));
  EXPECT_THAT(content_of(path("both/run.json")), HasSubstr("\"verdict\": \"confirmed\""));
  EXPECT_GT(trajectory("both").size(), trajectory("front").size());
}

TEST_F(TwoScanners, AWrongMountingIsToldWithItsAngleAndTheOptionThatMendsIt) {
  const std::string log = simulate("--mounting-error 0,0,5");
  ASSERT_EQ(map(log, "", "front").exit_code, 0);
  const CommandOutcome both = map(log, "--sensor ROBOTLASER1,ROBOTLASER2", "both");
  const std::string turned_deg = between(both.out, "sensor ROBOTLASER2 is turned by ", " +-");
  ASSERT_NE(turned_deg, "") << both.out;
  EXPECT_NEAR(std::stod(turned_deg), 5.0, 0.5);
  EXPECT_EQ(trajectory("both"), trajectory("front")) << "its scans change nothing";
  EXPECT_THAT(content_of(path("both/run.json")), HasSubstr("\"verdict\": \"refuted\""));
  const std::string mending = between(both.out, "--mounting ROBOTLASER2=", " ");
  EXPECT_THAT(map(log, "--sensor all --mounting ROBOTLASER2=" + mending, "mended").out,
              HasSubstr("ROBOTLASER2: its mounting fits"));
}

/// The log's second part begins with the other scanner: each keeps its number by its name.
TEST_F(TwoScanners, ALogInTwoPartsGivesTheMapOfTheWhole) {
  const std::string log = simulate();
  std::istringstream lines(content_of(log));
  std::string first;
  std::string second;
  int num_front = 0;
  for (std::string line; std::getline(lines, line);) {
    num_front += line.starts_with("ROBOTLASER1 ") ? 1 : 0;
    const bool is_behind = !second.empty() || (num_front > 20 && line.starts_with("ROBOTLASER2 "));
    (is_behind ? second : first) += line + "\n";
  }
  const std::string parts = folder_.write("1.clf", first) + " " + folder_.write("2.clf", second);
  const CommandOutcome whole = map(log, "--sensor all", "whole");
  const CommandOutcome of_parts = map(parts, "--sensor all", "parts");
  EXPECT_EQ(of_parts.err, "");
  EXPECT_EQ(between(of_parts.out, "sensor ROBOTLASER2", "written"),
            between(whole.out, "sensor ROBOTLASER2", "written"));
  EXPECT_EQ(trajectory("parts"), trajectory("whole"));
}

TEST_F(TwoScanners, ASweepUnderTwoNamesCountsOnce) {
  const std::string log = simulate();
  std::istringstream lines(content_of(log));
  std::string twice;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("ROBOTLASER1 ")) twice += "ROBOTLASER3" + line.substr(11) + "\n";
    twice += line + "\n";
  }
  ASSERT_EQ(map(log, "--sensor all", "once").exit_code, 0);
  const CommandOutcome both = map(folder_.write("twice.clf", twice), "--sensor all", "twice");
  EXPECT_THAT(both.err, HasSubstr("sensor ROBOTLASER3 repeats the sweeps of ROBOTLASER1"));
  EXPECT_EQ(trajectory("twice"), trajectory("once"));
}

TEST_F(TwoScanners, NamesThatTheLogDoesNotHaveAreTold) {
  const std::string log = simulate();
  const CommandOutcome further = map(log, "--sensor ROBOTLASER1,ROBOTLASER7", "further");
  EXPECT_EQ(further.exit_code, 0);
  EXPECT_THAT(further.err, HasSubstr("no scan of sensor ROBOTLASER7"));
  const CommandOutcome first = map(log, "--sensor ROBOTLASER7,ROBOTLASER1", "first");
  EXPECT_EQ(first.exit_code, 2);
  EXPECT_THAT(first.err, HasSubstr("no scan of sensor ROBOTLASER7"));
}

TEST_F(TwoScanners, MountingsThatAreNoneAreRefused) {
  for (const char* mounting : {"X", "X=1,2", "X=1,2,nan", "X=1e9,0,0", "X=1,2,3,4"}) {
    const CommandOutcome outcome =
        map("none.clf", "--mounting " + std::string(mounting), "refused");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("--mounting"));
  }
}

}  // namespace setsquare::cli_scanners_test
