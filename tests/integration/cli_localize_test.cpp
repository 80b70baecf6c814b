// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/integration/run_setsquare.hpp"

namespace setsquare::cli_localize_test {

using testing::CommandOutcome;
using testing::content_of;
using ::testing::HasSubstr;
using testing::run_setsquare;
using testing::TemporaryFolder;

/// A simulated drive and the map of it, made once.
class CommandLocalize : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    const std::string in = folder_->path().string();
    ASSERT_EQ(run_setsquare("simulate --building office --seed 5 --every 0.3 -o '" + in + "/sim'")
                  .exit_code,
              0);
    ASSERT_EQ(run_setsquare("map '" + in + "/sim/scans.clf' -o '" + in + "/map'").exit_code, 0);
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::string path(const std::string& name) {
    return "'" + (folder_->path() / name).string() + "'";
  }
  static std::string text(const std::string& name) { return content_of(folder_->path() / name); }

  static inline std::unique_ptr<TemporaryFolder> folder_;
};

std::vector<std::vector<double>> poses_of(const std::string& tum) {
  std::istringstream lines(tum);
  std::vector<std::vector<double>> poses;
  for (std::string line; std::getline(lines, line);) {
    double stamp = 0.0, x = 0.0, y = 0.0;
    if (std::sscanf(line.c_str(), "%lf %lf %lf", &stamp, &x, &y) == 3)
      poses.push_back({stamp, x, y});
  }
  return poses;
}

TEST_F(CommandLocalize, FindsTheLogInItsOwnMap) {
  const CommandOutcome outcome = run_setsquare("localize " + path("map") + " " +
                                               path("sim/scans.clf") + " -o " + path("where"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("found at scan"));
  const auto run = nlohmann::json::parse(text("where/run.json"));
  const auto num_scans = run.at("scans").get<std::size_t>();
  EXPECT_GE(run.at("localised").get<std::size_t>(), num_scans * 9 / 10);
  EXPECT_EQ(run.at("localised").get<std::size_t>() + run.at("ambiguous").get<std::size_t>() +
                run.at("lost").get<std::size_t>(),
            num_scans);
  // Where the map has the scans itself.
  const auto mapped = poses_of(text("map/trajectory.tum"));
  const auto localised = poses_of(text("where/trajectory.tum"));
  EXPECT_EQ(localised.size(), run.at("localised").get<std::size_t>());
  std::size_t k = 0;
  for (const auto& pose : localised) {
    while (k < mapped.size() && mapped[k][0] < pose[0] - 1e-6) ++k;
    ASSERT_LT(k, mapped.size());
    EXPECT_LT(std::hypot(mapped[k][1] - pose[1], mapped[k][2] - pose[2]), 0.2);
  }
  // A row for each scan, and a header.
  std::istringstream table(text("where/localisation.tsv"));
  std::size_t num_rows = 0;
  for (std::string line; std::getline(table, line);) ++num_rows;
  EXPECT_EQ(num_rows, num_scans + 1);
}

TEST_F(CommandLocalize, ReadsTheMapOfAnyProgramByItsYaml) {
  const CommandOutcome by_yaml = run_setsquare("localize " + path("map/map.yaml") + " " +
                                               path("sim/scans.clf") + " -o " + path("yaml"));
  ASSERT_EQ(by_yaml.exit_code, 0) << by_yaml.err;
  EXPECT_THAT(by_yaml.out, HasSubstr("found at scan"));
}

TEST_F(CommandLocalize, SaysWhatItCannotDo) {
  const CommandOutcome absent = run_setsquare("localize " + path("nothing") + " " +
                                              path("sim/scans.clf") + " -o " + path("a"));
  EXPECT_EQ(absent.exit_code, 2);
  EXPECT_THAT(absent.err, HasSubstr("nothing"));
  const CommandOutcome several = run_setsquare(
      "localize " + path("map") + " " + path("sim/scans.clf") + " --sensor all -o " + path("b"));
  EXPECT_EQ(several.exit_code, 2);
  EXPECT_THAT(several.err, HasSubstr("one scanner"));
  // Nothing is written onto the map that is read.
  const CommandOutcome onto = run_setsquare("localize " + path("map/map.yaml") + " " +
                                            path("sim/scans.clf") + " --start 1,2 -o " + path("c"));
  EXPECT_EQ(onto.exit_code, 2);
}

}  // namespace setsquare::cli_localize_test
