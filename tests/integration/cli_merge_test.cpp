// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare map --continue` and `setsquare merge`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "tests/integration/run_setsquare.hpp"
#include "tests/support/data_dir.hpp"
#include "tests/support/simulated_drive.hpp"
#include "tests/support/temporary_folder.hpp"

namespace setsquare::cli_merge_test {

namespace fs = std::filesystem;
using testing::CommandOutcome;
using testing::content_of;
using ::testing::HasSubstr;
using testing::run_setsquare;
using testing::Wall;

/// A drive as a CARMEN log, without odometry that means anything.
std::string log_of(const std::vector<Wall>& walls,
                   const std::vector<Eigen::Vector2d>& way,
                   double first_s) {
  std::ostringstream log;
  log.precision(12);
  const std::vector<Pose2> poses = testing::drive(way, 0.1, rad_from_deg(5.0));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto seed = static_cast<std::size_t>(first_s) + i;
    const Scan scan = testing::scan_of_walls(walls, poses[i], {}, 0.01, seed);
    log << "FLASER 180";
    for (const double range_m : scan.ranges_m) log << " " << std::min(range_m, 81.83);
    log << " 0 0 0 0 0 0 " << first_s + 0.2 * static_cast<double>(i) << " h 0\n";
  }
  return log.str();
}

const std::vector<Eigen::Vector2d> kAround = testing::way_around_the_room();
const std::vector<Eigen::Vector2d> kAcross{
    {2.0, 7.5}, {1.5, 5.0}, {2.5, 2.0}, {5.5, 2.5}, {3.0, 1.0}, {2.0, 5.0}};

class CommandMerge : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new testing::TemporaryFolder;
    const std::vector<Wall> room = testing::l_shaped_room();
    std::vector<Wall> image = room;
    for (Wall& wall : image) wall = {-wall.x1_m, wall.y1_m, -wall.x2_m, wall.y2_m};
    std::vector<Eigen::Vector2d> in_image = kAround;
    for (Eigen::Vector2d& corner : in_image) corner.x() *= -1.0;
    folder_->write("a.clf", log_of(room, kAround, 1000.0));
    folder_->write("b.clf", log_of(room, kAcross, 5000.0));
    folder_->write("image.clf", log_of(image, in_image, 9000.0));
    for (const char* name : {"a", "b", "image"}) {
      const CommandOutcome outcome =
          run("map " + path(std::string(name) + ".clf") + " --no-odometry -o " + path(name));
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    }
  }
  static void TearDownTestSuite() { delete folder_; }

  static std::string path(const std::string& name) {
    return "'" + (folder_->path() / name).string() + "'";
  }
  static CommandOutcome run(const std::string& arguments) { return run_setsquare(arguments); }
  static nlohmann::json run_json(const std::string& name) {
    return nlohmann::json::parse(content_of(folder_->path() / name / "run.json"));
  }
  static bool exists(const std::string& name) { return fs::exists(folder_->path() / name); }

  static testing::TemporaryFolder* folder_;
};

testing::TemporaryFolder* CommandMerge::folder_ = nullptr;

TEST_F(CommandMerge, AMapIsGoneOnWith) {
  const CommandOutcome outcome =
      run("map " + path("b.clf") + " --no-odometry --continue " + path("a") + " -o " + path("ab"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("session 2 of 2"));
  EXPECT_THAT(outcome.out, HasSubstr("joined to the map"));
  const nlohmann::json json = run_json("ab");
  ASSERT_EQ(json["sessions"].size(), 2U);
  EXPECT_TRUE(json["sessions"][1]["joined"]);
  EXPECT_EQ(json["num"]["scans"],
            run_json("a")["num"]["scans"].get<int>() + run_json("b")["num"]["scans"].get<int>());
  EXPECT_EQ(json["options"]["continue"], (folder_->path() / "a").string());
  // The outputs again, from the file: the same bytes.
  ASSERT_EQ(run("render " + path("ab") + " -o " + path("again")).exit_code, 0);
  for (const char* name : {"map.pgm", "run.json", "map.png", "report.html", "trajectory.tum"}) {
    EXPECT_TRUE(content_of(folder_->path() / "ab" / name) ==
                content_of(folder_->path() / "again" / name))
        << name;
  }
}

TEST_F(CommandMerge, WhatIsElsewhereStaysApart) {
  const CommandOutcome outcome = run("map " + path("image.clf") + " --no-odometry --continue " +
                                     path("a") + " -o " + path("apart"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("kept apart until it can be joined"));
  EXPECT_FALSE(run_json("apart")["sessions"][1]["joined"]);
  EXPECT_TRUE(exists("apart/pieces/2.tum"));
}

TEST_F(CommandMerge, MapsBecomeOneInAnyOrder) {
  for (const auto& [first, second] : {std::pair("a", "b"), std::pair("b", "a")}) {
    const std::string name = std::string("merged_") + first;
    const CommandOutcome outcome =
        run("merge " + path(first) + " " + path(std::string(second) + "/map.setsquare") + " -o " +
            path(name));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("joined to the map"));
    const nlohmann::json json = run_json(name);
    ASSERT_EQ(json["sessions"].size(), 2U);
    EXPECT_EQ(json["sessions"][0]["num_scans"], run_json(first)["num"]["scans"]);
    // The later of the two in time is the newer, whichever is named first.
    EXPECT_EQ(json["sessions"][0]["recency"], std::string(first) == "a" ? 0 : 1);
    EXPECT_FALSE(exists(name + "/timing.json"));
  }
}

TEST_F(CommandMerge, MapsThatShareNothingAreRefusedWithTheReason) {
  const CommandOutcome outcome =
      run("merge " + path("a") + " " + path("b") + " " + path("image") + " -o " + path("none"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("image: cannot be merged with"));
  EXPECT_THAT(outcome.err, HasSubstr("pairs of places"));
  EXPECT_FALSE(exists("none/run.json"));
}

TEST_F(CommandMerge, NoMapIsWrittenOnto) {
  const std::string before = content_of(folder_->path() / "a" / "map.setsquare");
  EXPECT_EQ(run("map " + path("b.clf") + " --continue " + path("a") + " -o " + path("a")).exit_code,
            2);
  EXPECT_EQ(run("merge " + path("b") + " " + path("a") + " -o " + path("a")).exit_code, 2);
  EXPECT_TRUE(content_of(folder_->path() / "a" / "map.setsquare") == before);
}

TEST_F(CommandMerge, WhatIsNoMapIsToldInWords) {
  const std::string log = "map " + path("b.clf") + " -o " + path("none") + " --continue ";
  EXPECT_EQ(run(log + path("absent")).exit_code, 2);
  EXPECT_EQ(run(log + path("a.clf")).exit_code, 2);
  EXPECT_EQ(run("merge " + path("a") + " -o " + path("none")).exit_code, 2);
  ASSERT_EQ(run("map " + path("a.clf") + " --preset paper -o " + path("paper")).exit_code, 0);
  const CommandOutcome outcome = run(log + path("paper"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("does not tell its track"));
  EXPECT_EQ(run(log + path("a") + " --preset paper").exit_code, 2);
}

}  // namespace setsquare::cli_merge_test
