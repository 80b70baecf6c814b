// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "tests/integration/run_setsquare.hpp"
#include "tests/support/data_dir.hpp"

namespace setsquare::cli_explain_test {

using testing::CommandOutcome;
using testing::content_of;
using ::testing::HasSubstr;
using testing::run_setsquare;
using testing::TemporaryFolder;

/// A FLASER line of 181 beams in a room of 9 m x 6 m, from (x, 2.5) looking along the room.
std::string scan_line(double x_m, const std::string& stamp) {
  std::string line = "FLASER 181";
  for (int beam = 0; beam <= 180; ++beam) {
    const double bearing_rad = (beam - 90) * std::numbers::pi / 180.0;
    const double c = std::max(std::cos(bearing_rad), 1e-9);
    const double s = std::sin(bearing_rad);
    const double to_side_m = s > 0.0 ? 3.5 / s : s < 0.0 ? -2.5 / s : 1e9;
    line += " " + std::to_string(std::min((9.0 - x_m) / c, to_side_m));
  }
  return line + " 0 0 0 0 0 0 " + stamp + " host 0\n";
}

std::string room_log() {
  return scan_line(2.0, "10.500000") + scan_line(2.4, "11.000000") + scan_line(2.9, "11.500000");
}

std::ptrdiff_t num_lines(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

/// What the picture and the page of a preset show.
std::vector<std::string> sections_of(const std::string& preset) {
  std::vector<std::string> sections = {"Proposals, and why they lost",
                                       "laid over each other",
                                       "scan 0, stamp 10.500000",
                                       "scan 2, stamp 11.500000",
                                       "room.clf"};
  const std::vector<std::string> own =
      preset == "paper" ? std::vector<std::string>{"before and after thinning",
                                                   "Direction curve M(theta)",
                                                   "Profiles at the dominant direction",
                                                   "Correlation against the shift"}
                        : std::vector<std::string>{"The two scans as surfaces",
                                                   "Rotations that are proposed",
                                                   "From proposals to the answer",
                                                   "What the scores are made of",
                                                   "The verdict, and the rule that decided"};
  sections.insert(sections.end(), own.begin(), own.end());
  return sections;
}

TEST(CommandExplain, WritesThePictureAndThePage) {
  const TemporaryFolder folder;
  const std::string log = folder.write("room.clf", room_log());
  for (const std::string preset : {"default", "paper"}) {
    for (const char* name : {"match.svg", "match.html"}) {
      const std::filesystem::path picture = folder.path() / name;
      const CommandOutcome outcome = run_setsquare("explain " + log + " 0 11.5 --preset " + preset +
                                                   " -o '" + picture.string() + "'");
      EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
      EXPECT_EQ(outcome.err, "");
      EXPECT_THAT(outcome.out, HasSubstr("rotation "));
      const std::string content = content_of(picture);
      for (const std::string& section : sections_of(preset)) {
        EXPECT_THAT(content, HasSubstr(section)) << name << ", " << preset;
      }
      EXPECT_EQ(content.find("thinning") != std::string::npos, preset == "paper") << name;
    }
  }
}

TEST(CommandExplain, ShowsTheNameOfTheLogAsItIs) {
  const TemporaryFolder folder;
  const std::string log = folder.write("B\xc3\xbcro_\xe6\x97\xa5.clf", room_log());
  const std::filesystem::path picture = folder.path() / "match.html";
  const CommandOutcome outcome =
      run_setsquare("explain " + log + " 0 1 -o '" + picture.string() + "'");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(content_of(picture), HasSubstr("B\xc3\xbcro_\xe6\x97\xa5.clf"));
}

TEST(CommandExplain, WhatItCannotFindOrWriteIsOneLineAndCodeTwo) {
  const TemporaryFolder folder;
  const std::string log = folder.write("room.clf", room_log());
  const std::string picture = (folder.path() / "match.svg").string();
  struct Case {
    std::string arguments;
    std::string reason;
  };
  const Case cases[] = {
      {log + " 0 3 -o '" + picture + "'", "scan 3 is beyond the last of its 3 scans"},
      {log + " 0 11.25 -o '" + picture + "'", "scan 11.25 is the stamp of none of its 3 scans"},
      {log + " 0 one -o '" + picture + "'", "scan one is neither"},
      {log + " 0 1.x -o '" + picture + "'", "scan 1.x is neither"},
      {log + " 0 1 -o '" + picture + ".pdf'", "must end in .svg or .html"},
      {log + " 0 1 -o '" + (folder.path() / "nowhere" / "m.svg").string() + "'", "nowhere"},
      {"no.clf 0 1 -o '" + picture + "'", "no.clf"}};
  for (const Case& wrong : cases) {
    const CommandOutcome outcome = run_setsquare("explain " + wrong.arguments);
    EXPECT_EQ(outcome.exit_code, 2) << wrong.arguments;
    EXPECT_THAT(outcome.err, HasSubstr(wrong.reason));
    EXPECT_EQ(num_lines(outcome.err), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(CommandExplain, ReportsACutGzip) {
  const TemporaryFolder folder;
  const std::string log = folder.write("room.clf", room_log());
  const std::string cut = "'" + (folder.path() / "cut.gz").string() + "'";
  const std::string command = "gzip -c " + log + " | head -c -12 >" + cut;
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string to_picture = " -o '" + (folder.path() / "match.svg").string() + "'";
  const CommandOutcome absent = run_setsquare("explain " + cut + " 0 3" + to_picture);
  EXPECT_EQ(absent.exit_code, 2);
  EXPECT_THAT(absent.err, HasSubstr("gzip"));
  EXPECT_EQ(num_lines(absent.err), 1) << absent.err;
  const CommandOutcome found = run_setsquare("explain " + log + " 0 2" + to_picture);
  EXPECT_EQ(found.exit_code, 0) << found.err;
  EXPECT_EQ(found.err, "");
}

TEST(CommandExplain, RevisitInARealBuilding) {
  const auto log = testing::data_file("intel/intel.clf");
  if (!log) GTEST_SKIP() << "intel/intel.clf is absent (SETSQUARE_DATA_DIR)";
  const TemporaryFolder folder;
  const std::filesystem::path picture = folder.path() / "match.html";
  const CommandOutcome outcome =
      run_setsquare("explain '" + log->string() + "' 976052918.409213 976053249.871827 -o '" +
                    picture.string() + "'");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Matched: "));
  EXPECT_GT(content_of(picture).size(), 50'000U);
}

}  // namespace setsquare::cli_explain_test
