// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "setsquare/core/angle.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"
#include "tests/integration/run_setsquare.hpp"

namespace setsquare::cli_audit_test {

using testing::CommandOutcome;
using testing::content_of;
using ::testing::HasSubstr;
using testing::run_setsquare;
using testing::TemporaryFolder;

/// A scan half-way between two that saw the same place, a long way apart.
std::size_t scan_before_a_revisit(const Trajectory& poses) {
  constexpr std::size_t kApart = 60;
  std::size_t found = poses.size() / 2;
  double nearest_m = 1.0;
  for (std::size_t i = 0; i + kApart < poses.size(); ++i) {
    for (std::size_t j = i + kApart; j < poses.size(); ++j) {
      const Pose2 between = poses[i].pose.inverse() * poses[j].pose;
      const double apart_m = between.translation().norm();
      if (apart_m >= nearest_m || std::abs(between.theta_rad) > rad_from_deg(30.0)) continue;
      nearest_m = apart_m;
      found = (i + j) / 2;
    }
  }
  return found;
}

/// A simulated office: its log, the truth, and the truth bent by 12 deg between two visits.
class CommandAudit : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    ASSERT_EQ(run_setsquare("simulate --building office --seed 2014 --every 0.3 -o " + path("sim"))
                  .exit_code,
              0);
    Trajectory bent = read_trajectory_tum((folder_->path() / "sim" / "truth.tum").string());
    bend_ = scan_before_a_revisit(bent);
    const Pose2 T_map_bend = bent[bend_].pose;
    const Pose2 T_map_bent =
        T_map_bend * Pose2{0.0, 0.0, rad_from_deg(12.0)} * T_map_bend.inverse();
    for (std::size_t i = bend_; i < bent.size(); ++i) {
      bent[i].pose = T_map_bent * bent[i].pose;
    }
    write_trajectory_tum((folder_->path() / "bent.tum").string(), bent);
    ASSERT_EQ(run_setsquare("map " + path("sim/scans.clf") + " -o " + path("map")).exit_code, 0);
  }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }

  static std::string path(const std::string& name) {
    return "'" + (folder_->path() / name).string() + "'";
  }
  static CommandOutcome audit(const std::string& map, const std::string& options = "") {
    return run_setsquare("audit " + path("sim/scans.clf") + " " + path(map) + " " + options);
  }

  static TemporaryFolder* folder_;
  static std::size_t bend_;  ///< The first scan behind the bend.
};

TemporaryFolder* CommandAudit::folder_ = nullptr;
std::size_t CommandAudit::bend_ = 0;

TEST_F(CommandAudit, TheTruthAndItsMapAreConsistent) {
  for (const char* const map : {"sim/truth.tum", "map"}) {
    const CommandOutcome outcome = audit(map, "--strict");
    EXPECT_EQ(outcome.exit_code, 0) << map << outcome.out;
    EXPECT_EQ(outcome.out.rfind("map: consistent (", 0), 0U) << outcome.out;
    EXPECT_EQ(outcome.err, "");
  }
}

TEST_F(CommandAudit, ABentTrajectoryIsDoubtfulAndTheExitCodeSaysSoOnlyIfAsked) {
  const CommandOutcome outcome = audit("bent.tum");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out.rfind("map: doubtful in ", 0), 0U) << outcome.out;
  EXPECT_THAT(outcome.out, HasSubstr("  1. at ("));
  EXPECT_THAT(outcome.out, HasSubstr("contradicting pairs: scans "));
  EXPECT_EQ(audit("bent.tum", "--strict").exit_code, 3);
}

TEST_F(CommandAudit, JsonHasTheCountsAndTheDoubts) {
  const auto json = nlohmann::json::parse(audit("bent.tum", "--json").out);
  const auto& counts = json.at("audit");
  EXPECT_EQ(counts.at("agreeing").get<int>() + counts.at("contradicting").get<int>(),
            counts.at("matched").get<int>());
  EXPECT_GE(counts.at("seconded").get<int>(), 3);
  const auto& doubt = json.at("doubts").at(0);
  EXPECT_EQ(doubt.at("number"), 1);
  EXPECT_EQ(doubt.at("kind"), "contradicting pairs");
  EXPECT_GE(doubt.at("first_scan").get<std::size_t>(), bend_);
  for (const char* const name :
       {"x_m", "y_m", "num_scans", "first_stamp", "last_stamp", "reason"}) {
    EXPECT_TRUE(doubt.contains(name)) << name;
  }
}

TEST_F(CommandAudit, LeavesItsInputsAsTheyWere) {
  const std::string run = content_of(folder_->path() / "map" / "run.json");
  const std::string trajectory = content_of(folder_->path() / "map" / "trajectory.tum");
  ASSERT_EQ(audit("map").exit_code, 0);
  EXPECT_EQ(content_of(folder_->path() / "map" / "run.json"), run);
  EXPECT_EQ(content_of(folder_->path() / "map" / "trajectory.tum"), trajectory);
}

TEST_F(CommandAudit, MapTellsTheVerdictFirstAndRecordsIt) {
  const std::string command = "map " + path("sim/scans.clf") + " -o " + path("again");
  const CommandOutcome outcome = run_setsquare(command + " --strict");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out.rfind("map: consistent (", 0), 0U) << outcome.out;
  const auto run = nlohmann::json::parse(content_of(folder_->path() / "again" / "run.json"));
  EXPECT_GT(run.at("audit").at("agreeing").get<int>(), 20);
  EXPECT_TRUE(run.at("doubts").empty());
  const std::string trajectory = content_of(folder_->path() / "again" / "trajectory.tum");

  const CommandOutcome unaudited = run_setsquare(command + " --no-audit");
  EXPECT_EQ(unaudited.out.find("map: "), std::string::npos);
  const auto run2 = nlohmann::json::parse(content_of(folder_->path() / "again" / "run.json"));
  EXPECT_TRUE(run2.at("audit").is_null());
  EXPECT_EQ(content_of(folder_->path() / "again" / "trajectory.tum"), trajectory)
      << "the audit changes no pose";
}

TEST_F(CommandAudit, WhatIsNoMapIsRefused) {
  EXPECT_EQ(audit("absent.tum").exit_code, 2);
  EXPECT_EQ(audit("sim/scans.clf").exit_code, 2) << "a log is no trajectory";
  EXPECT_EQ(audit("sim").exit_code, 2) << "a folder without a map";
  const std::string late = folder_->write("late.tum", "99999.0 0 0 0 0 0 0 1\n");
  const CommandOutcome outcome = run_setsquare("audit " + path("sim/scans.clf") + " " + late);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--max-time-difference"));
}

}  // namespace setsquare::cli_audit_test
