// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Logs that are spoilt in one way: `info` and `map` tell it, and what they propose mends it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/integration/run_setsquare.hpp"
#include "tests/support/data_dir.hpp"

namespace setsquare::cli_log_faults_test {

using Json = nlohmann::json;
using testing::CommandOutcome;
using testing::content_of;
using ::testing::HasSubstr;
using testing::run_setsquare;
using testing::TemporaryFolder;

/// A simulated log in which `change` makes a range's text another.
std::string spoilt_log(const TemporaryFolder& folder,
                       const std::function<std::string(const std::string&, std::size_t)>& change) {
  const auto out = folder.path() / "sim";
  const CommandOutcome simulated = run_setsquare(
      "simulate --building office --seed 2001 --every 0.3 --no-people --field-of-view 180 "
      "--beams 361 -o '" +
      out.string() + "'");
  EXPECT_EQ(simulated.exit_code, 0) << simulated.err;
  constexpr std::size_t kFirstRange = 9;
  std::istringstream lines(content_of(out / "scans.clf"));
  std::string log;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::size_t num_words = 0;
    for (std::string word; words >> word; ++num_words) {
      const bool is_range = line.starts_with("ROBOTLASER1") && num_words >= kFirstRange &&
                            num_words < kFirstRange + 361;
      log += (num_words == 0 ? "" : " ") + (is_range ? change(word, num_words) : word);
    }
    log += "\n";
  }
  return folder.write("spoilt.clf", log);
}

bool has_kind(const Json& findings, const std::string& kind) {
  return std::ranges::any_of(findings,
                             [&](const Json& finding) { return finding["kind"] == kind; });
}

TEST(CommandLogFaults, MapTellsWhatInfoTells) {
  const TemporaryFolder folder;
  const std::string log = spoilt_log(folder, [](const std::string& range, std::size_t word) {
    return word % 40 == 0 ? std::string("0.007") : range;
  });
  const auto out = folder.path() / "map";
  const CommandOutcome info = run_setsquare("info --json " + log);
  const CommandOutcome map = run_setsquare("map " + log + " -o '" + out.string() + "'");
  ASSERT_EQ(map.exit_code, 0) << map.err;
  EXPECT_THAT(map.out, HasSubstr("what is wrong with the log"));
  EXPECT_THAT(map.out, HasSubstr("error codes"));
  const Json of_info = Json::parse(info.out)["findings"];
  EXPECT_EQ(Json::parse(content_of(out / "run.json"))["findings"], of_info);
  EXPECT_TRUE(has_kind(of_info, "error_codes"));
}

TEST(CommandLogFaults, RangesInMillimetresAreToldAndMended) {
  const TemporaryFolder folder;
  const std::string log = spoilt_log(folder, [](const std::string& range, std::size_t) {
    return std::to_string(static_cast<int>(1000.0 * std::stod(range)));
  });
  const std::string out = " -o '" + (folder.path() / "map").string() + "'";
  const CommandOutcome refused = run_setsquare("map " + log + out);
  EXPECT_EQ(refused.exit_code, 2) << refused.out;
  EXPECT_THAT(refused.err, HasSubstr("in millimetres? Try --range-scale 0.001"));
  const CommandOutcome mended = run_setsquare("map " + log + out + " --range-scale 0.001");
  EXPECT_EQ(mended.exit_code, 0) << mended.err;
  EXPECT_EQ(run_setsquare("map " + log + out + " --range-scale 0").exit_code, 2);
}

/// A log of the folder of cases, its truth, and the largest error that its map may have.
struct Case {
  std::string name;
  std::string options;
  std::string told;  ///< A part of what `map` tells.
  double max_rmse_m;
};

class LogCase : public ::testing::TestWithParam<Case> {};

TEST_P(LogCase, IsToldAndMapped) {
  const auto log = testing::data_file("../cases/" + GetParam().name + "/log.clf.gz");
  if (!log) GTEST_SKIP() << "no folder of cases";
  const TemporaryFolder folder;
  const auto out = folder.path() / "map";
  const CommandOutcome info = run_setsquare("info '" + log->string() + "'");
  EXPECT_THAT(info.out, HasSubstr(GetParam().told));
  const CommandOutcome map =
      run_setsquare("map '" + log->string() + "' -o '" + out.string() + "' " + GetParam().options);
  ASSERT_EQ(map.exit_code, 0) << map.err;
  const CommandOutcome ate =
      run_setsquare("evaluate ate --json '" + (out / "trajectory.tum").string() + "' '" +
                    (log->parent_path() / "truth.tum").string() + "'");
  EXPECT_LT(Json::parse(ate.out)["translation_m"]["rmse"], GetParam().max_rmse_m) << map.out;
}

INSTANTIATE_TEST_SUITE_P(
    Cases,
    LogCase,
    ::testing::Values(
        Case{"flaser-360-degrees",
             "--field-of-view 360 --max-range 8",
             "try --field-of-view 360",
             0.05},
        Case{"hokuyo-error-codes", "", "error codes", 0.1},
        Case{"isolated-short-returns", "", "stand alone", 0.05},
        Case{"odometry-all-zero", "", "try --no-odometry", 0.2},
        Case{"robot-carried", "", "nothing found", 0.3},
        Case{"round-hall-with-odometry", "", "nothing found", 0.1},
        Case{"same-scan-repeated", "", "repeat the one before", 0.2},
        Case{"scans-mirrored-against-odometry", "--mirror-scans", "Try --mirror-scans", 0.05}),
    [](const auto& instance) {
      std::string name = instance.param.name;
      std::erase(name, '-');
      return name;
    });

TEST(CommandLogFaults, TooFewBeamsAreNamed) {
  const auto log = testing::data_file("../cases/eight-beams/log.clf.gz");
  if (!log) GTEST_SKIP() << "no folder of cases";
  const TemporaryFolder folder;
  const CommandOutcome map =
      run_setsquare("map '" + log->string() + "' -o '" + (folder.path() / "map").string() + "'");
  EXPECT_EQ(map.exit_code, 2);
  EXPECT_THAT(map.err, HasSubstr("8 beams a scan are too few"));
}

TEST(CommandLogFaults, ATruthWithQuaternionsWFirst) {
  const TemporaryFolder folder;
  std::string turning;
  std::string w_first;
  for (int i = 0; i < 20; ++i) {
    const double half_rad = 0.15 * i;
    const std::string place = std::to_string(i) + ".0 " + std::to_string(0.5 * i) + " 0 0 ";
    const std::string z = std::to_string(std::sin(half_rad));
    const std::string w = std::to_string(std::cos(half_rad));
    turning += place + "0 0 " + z + " " + w + "\n";
    w_first += place + w + " 0 0 " + z + "\n";
  }
  const std::string files =
      folder.write("t.tum", turning) + " " + folder.write("truth.tum", w_first);
  const CommandOutcome told = run_setsquare("evaluate ate " + files);
  EXPECT_EQ(told.exit_code, 0);
  EXPECT_THAT(told.err, HasSubstr("written w first"));
  const CommandOutcome mended = run_setsquare("evaluate ate --w-first --json " + files);
  EXPECT_EQ(mended.err, "");
  EXPECT_LT(Json::parse(mended.out)["rotation_deg"]["max"], 0.01);
}

/// The output would state as known what was assumed.
TEST(CommandLogFaults, ConvertTellsThatTheAnglesAreAssumed) {
  const TemporaryFolder folder;
  const std::string log =
      folder.write("scans.clf", "FLASER 3 1.0 2.0 1.5 0 0 0 0 0 0 1.0 host 1.0\n");
  const std::string output = " '" + (folder.path() / "scans.csv").string() + "'";
  EXPECT_THAT(run_setsquare("convert " + log + output).err, HasSubstr("states no angles"));
  EXPECT_THAT(run_setsquare("convert " + log + output + " --field-of-view 240").err,
              ::testing::Not(HasSubstr("states no angles")));
}

}  // namespace setsquare::cli_log_faults_test
