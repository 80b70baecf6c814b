// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "setsquare/io/logs/open_log.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"
#include "tests/integration/run_setsquare.hpp"
#include "tests/support/pose_matchers.hpp"
#include "tests/support/xml_fault.hpp"

namespace setsquare::cli_simulate_test {

using testing::CommandOutcome;
using testing::content_of;
using ::testing::HasSubstr;
using testing::PoseNear;
using testing::run_setsquare;
using testing::TemporaryFolder;

/// A room of 6 m x 4 m with a pillar; the way goes around it.
const char* const kRoom =
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 600 400'>\n"
    "<rect width='600' height='400'/>\n"
    "<circle class='pillar' cx='300' cy='200' r='30'/>\n"
    "<polyline id='route' points='100,100 500,100 500,300'/>\n"
    "</svg>\n";

/// The same room as a map of 0.1 m cells whose lower left corner lies at (-1, -1).
std::string room_image() {
  std::string image = "P2 62 42 255";
  for (int row = 0; row < 42; ++row) {
    for (int column = 0; column < 62; ++column) {
      const bool is_wall = row == 0 || row == 41 || column == 0 || column == 61;
      image += is_wall ? " 0" : " 254";
    }
  }
  return image;
}

/// Runs `simulate ARGUMENTS -o FOLDER/out` and returns that folder.
std::filesystem::path simulate(const TemporaryFolder& folder, const std::string& arguments) {
  const auto out = folder.path() / "out";
  const CommandOutcome outcome =
      run_setsquare("simulate " + arguments + " -o '" + out.string() + "'");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("written: "));
  return out;
}

std::vector<LogRecord> records_of(const std::filesystem::path& log) {
  LogOptions options;
  options.scans_only = false;
  const auto reader = open_log(log.string(), options);
  std::vector<LogRecord> records;
  while (const LogRecord* record = reader->next()) records.push_back(*record);
  EXPECT_EQ(summary(reader->problems()), "");
  return records;
}

TEST(CommandSimulate, AnSvgPlanGivesTheLogTheTruthAndAPicture) {
  const TemporaryFolder folder;
  const auto out =
      simulate(folder, "--plan " + folder.write("room.svg", kRoom) + " --plan-scale 0.01 --rate 4");
  const Trajectory truth = read_trajectory_tum((out / "truth.tum").string());
  const auto records = records_of(out / "scans.clf");
  ASSERT_GT(truth.size(), 40U) << "5.7 m at 0.5 m/s and 4 scans a second";
  ASSERT_EQ(records.size(), 2 * truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const LogRecord& true_pose = records[2 * i];
    const LogRecord& scan = records[2 * i + 1];
    ASSERT_EQ(true_pose.kind, RecordKind::kTruePose);
    ASSERT_EQ(scan.kind, RecordKind::kScan);
    EXPECT_EQ(scan.stamp, truth[i].stamp);
    EXPECT_EQ(true_pose.stamp, truth[i].stamp);
    EXPECT_EQ(scan.scan.num_beams(), 1081U);
    EXPECT_THAT(*true_pose.T_map_base, PoseNear(truth[i].pose, testing::PoseTolerance{2e-6, 2e-6}));
    EXPECT_EQ(*true_pose.T_odom_base, *scan.T_odom_base);
  }
  EXPECT_EQ(truth[4].stamp.ns, 1'000'000'000);
  EXPECT_THAT(truth.front().pose,
              PoseNear(Pose2{1.0, -1.0, 0.0}, testing::PoseTolerance{0.01, 0.01}));
  EXPECT_NEAR(truth.back().pose.x_m, 5.0, 0.01);
  EXPECT_NEAR(truth.back().pose.y_m, -3.0, 0.13);
  // The first scan looks along the upper wall: ahead 5 m, to the left 1 m.
  const Scan& first = records[1].scan;
  EXPECT_NEAR(first.ranges_m[540], 5.0, 0.15);
  EXPECT_NEAR(first.ranges_m[540 + 360], 1.0, 0.05);
  const std::string picture = content_of(out / "plan.svg");
  EXPECT_EQ(testing::xml_fault(picture), std::nullopt);
  EXPECT_THAT(picture, HasSubstr("pillar"));
}

TEST(CommandSimulate, AMapServersMapGivesTheSameRoom) {
  const TemporaryFolder folder;
  static_cast<void>(folder.write("room.pgm", room_image()));
  const std::string plan = folder.write(
      "room.yaml", "image: room.pgm\nresolution: 0.1\norigin: [-1, -1, 0]\nnegate: 0\n");
  const auto out = simulate(
      folder, "--plan " + plan + " --route '0.1,0.1 4.2,0.1' --every 0.4 --scanner low-cost-360");
  const Trajectory truth = read_trajectory_tum((out / "truth.tum").string());
  ASSERT_EQ(truth.size(), 11U);
  const auto records = records_of(out / "scans.clf");
  double ahead_m = 0.0;
  for (std::size_t beam = 0; beam < records[1].scan.num_beams(); ++beam) {
    const bool is_ahead = std::abs(wrap_to_pi(records[1].scan.bearing_rad(beam))) < 0.02;
    if (is_ahead) ahead_m = std::max(ahead_m, records[1].scan.ranges_m[beam]);
  }
  EXPECT_NEAR(ahead_m, 5.0, 0.3) << "from x = 0.1 to the inner side of the wall at 5.1";
}

TEST(CommandSimulate, TheSameSeedTheSameFilesAnotherSeedAnotherRun) {
  const TemporaryFolder one;
  const TemporaryFolder two;
  const TemporaryFolder other;
  const auto first = simulate(one, "--building corridor --seed 3 --every 1");
  const auto second = simulate(two, "--building corridor --seed 3 --every 1");
  const auto third = simulate(other, "--building corridor --seed 4 --every 1");
  for (const std::string name : {"scans.clf", "truth.tum", "plan.svg"}) {
    EXPECT_EQ(content_of(first / name), content_of(second / name)) << name;
    EXPECT_NE(content_of(first / name), content_of(third / name)) << name;
  }
}

TEST(CommandSimulate, OdometryDriftsUnlessAskedNotTo) {
  const TemporaryFolder folder;
  const std::string plan = "--plan " + folder.write("room.svg", kRoom) + " --plan-scale 0.01";
  const auto end_error_m = [&](const std::string& option) {
    const auto records = records_of(simulate(folder, plan + option) / "scans.clf");
    const LogRecord& first = records.front();
    const LogRecord& last = records[records.size() - 2];
    const Pose2 truth = first.T_map_base->inverse() * *last.T_map_base;
    const Pose2 wheels = first.T_odom_base->inverse() * *last.T_odom_base;
    return (truth.inverse() * wheels).translation().norm();
  };
  EXPECT_GT(end_error_m(""), 0.005);
  EXPECT_LT(end_error_m(" --no-odometry-drift"), 1e-4);
}

TEST(CommandSimulate, EveryBuildingAndScannerCanBeHad) {
  for (const std::string name : {"office", "hall", "wings", "corridor", "round", "hallway"}) {
    const TemporaryFolder folder;
    const auto out = simulate(folder,
                              "--building " + name +
                                  " --every 1 --every-angle 45 --field-of-view 180 --beams 61 "
                                  "--no-people");
    const auto records = records_of(out / "scans.clf");
    ASSERT_GE(records.size(), 10U) << name;
    EXPECT_EQ(records[1].scan.num_beams(), 61U);
    EXPECT_NEAR(records[1].scan.bearing_step_rad, rad_from_deg(3.0), 1e-8);
  }
}

TEST(CommandSimulate, APatrolDrivesThereAndBack) {
  const TemporaryFolder folder;
  const std::string room = folder.write("room.svg", kRoom);
  const std::string options = "--plan " + room + " --plan-scale 0.01 --route '1,-1 5,-1' --rate 1";
  const auto once = read_trajectory_tum((simulate(folder, options) / "truth.tum").string());
  const auto patrol =
      read_trajectory_tum((simulate(folder, options + " --rounds 3") / "truth.tum").string());
  EXPECT_GT(patrol.size(), 6 * once.size() - 6);
  EXPECT_NEAR(patrol.back().pose.x_m, patrol.front().pose.x_m, 0.5);
  int num_turns = 0;  // At either end of the way.
  for (std::size_t i = 2; i < patrol.size(); ++i) {
    const double before_m = patrol[i - 1].pose.x_m - patrol[i - 2].pose.x_m;
    const double step_m = patrol[i].pose.x_m - patrol[i - 1].pose.x_m;
    num_turns += before_m * step_m < 0.0 || (before_m != 0.0 && step_m == 0.0) ? 1 : 0;
  }
  EXPECT_GE(num_turns, 5);
}

TEST(CommandSimulate, TheLogIsOneThatTheMapperMaps) {
  const TemporaryFolder folder;
  const auto out = simulate(folder, "--building office --seed 1 --every 0.2");
  const CommandOutcome mapped = run_setsquare("map '" + (out / "scans.clf").string() +
                                              "' --no-odometry -o '" + out.string() + "'");
  ASSERT_EQ(mapped.exit_code, 0) << mapped.err;
  const Trajectory truth = read_trajectory_tum((out / "truth.tum").string());
  const Trajectory answer = read_trajectory_tum((out / "trajectory.tum").string());
  ASSERT_EQ(answer.size(), truth.size());
  const Pose2 T_truth_answer = truth.front().pose * answer.front().pose.inverse();
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_THAT(T_truth_answer * answer[i].pose,
                PoseNear(truth[i].pose, testing::PoseTolerance{0.2, rad_from_deg(3.0)}));
  }
}

TEST(CommandSimulate, AFastTurnSkewsTheScansAndTheMapperSetsThemStraight) {
  const TemporaryFolder folder;
  const auto out = simulate(folder,
                            "--building office --no-people --scanner low-cost-360 --rate 7 "
                            "--sweep-time 0.142 --spin 360 --turn-rate 180 --format jsonl");
  const auto records = records_of(out / "scans.jsonl");
  ASSERT_GT(records.size(), 2U);
  const Scan& scan = records[1].scan;
  EXPECT_NEAR(scan.time_increment_s * static_cast<double>(scan.num_beams() - 1), 0.142, 1e-9);
  const auto map = folder.path() / "map";
  const CommandOutcome outcome =
      run_setsquare("map '" + (out / "scans.jsonl").string() + "' --no-odometry --to 3.9 -o '" +
                    map.string() + "'");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("as stated; scans are deskewed"));
  const Trajectory mapped = read_trajectory_tum((map / "trajectory.tum").string());
  EXPECT_NEAR(wrap_to_pi(mapped.back().pose.theta_rad - mapped.front().pose.theta_rad),
              0.0,
              rad_from_deg(0.5));
}

TEST(CommandSimulate, BadInputIsOneLineAndLeavesNothingBehind) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "out";
  const std::string room = folder.write("room.svg", kRoom);
  const std::string no_route = folder.write("no.svg", "<svg><line x2='1'/></svg>");
  const std::string cut =
      folder.write("cut.yaml", "image: cut.pgm\nresolution: 1\norigin: [0,0,0]");
  static_cast<void>(folder.write("cut.pgm", "P5 10 10 255\nabc"));
  static_cast<void>(folder.write("room.pgm", room_image()));
  ASSERT_EQ(::mkfifo((folder.path() / "pipe.pgm").c_str(), 0600), 0);
  const std::string map =
      folder.write("room.yaml", "image: room.pgm\nresolution: 0.1\norigin: [-1, -1, 0]");
  const std::string fine =
      folder.write("fine.yaml", "image: room.pgm\nresolution: 1e-300\norigin: [0, 0, 0]");
  const std::string piped =
      folder.write("piped.yaml", "image: pipe.pgm\nresolution: 0.1\norigin: [0, 0, 0]");
  const auto expect_error = [&](const std::string& arguments, const std::string& expected) {
    const CommandOutcome outcome =
        run_setsquare("simulate " + arguments + " -o '" + out.string() + "'");
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr(expected)) << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(out)) << arguments;
  };
  expect_error("--building castle", "castle");
  expect_error("--rounds 0", "--rounds");
  expect_error("--seed many", "many");
  expect_error("--building office --plan " + room, "--plan");
  expect_error("--route '1,1 2,2'", "--plan");
  expect_error("--plan absent.svg", "absent.svg: No such file");
  expect_error("--plan " + no_route, "no.svg: no route");
  expect_error("--plan " + room + " --route 1,1", "two points");
  expect_error("--plan " + room + " --route '1,1 2'", "point 2");
  expect_error("--plan " + room + " --route '100,-200 500,-200'",
               "through a wall at 270.00,-200.00");
  expect_error("--plan " + room + " --route '-100,-100 900,-100'",
               "leaves the plan at -100.00,-100.00");
  expect_error("--plan " + map + " --route '-0.95,1 -0.95,2'", "stands in a wall at -0.95,1.00");
  expect_error("--plan " + map + " --route '1,1 50,1'", "leaves the map at 50.00,1.00");
  expect_error("--plan " + fine + " --route '1,1 2,1'", "line 2: resolution must be from 0.0001");
  expect_error("--plan " + piped + " --route '1,1 2,1'", "pipe.pgm: not a regular file");
  expect_error("--plan " + cut + " --route '1,1 2,2'", "cut.pgm, offset 16: the image ends");
  expect_error("--plan " + folder.write("plan.dxf", "x") + " --route '1,1 2,2'", ".svg, .yaml");
  expect_error("--seed -1", "--seed: -1 is not a whole number from 0");
  expect_error("--speed 0", "--speed: 0 is not a number above 0");
  expect_error("--every nan", "--every");
  expect_error("--beams 1000000000", "--beams");
  expect_error("--rate 1000", "at most");
  expect_error("--speed 1e-9", "a million scans");
  expect_error("--rate 5 --every 1", "--every");
  expect_error("--beams 1", "--beams: 1 is not a whole number from 2 to 65536");
  expect_error("--field-of-view 400", "--field-of-view: 400 is not a number above 0");
}

}  // namespace setsquare::cli_simulate_test
