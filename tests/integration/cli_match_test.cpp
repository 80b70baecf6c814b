// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <Eigen/LU>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "tests/integration/run_setsquare.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare::cli_match_test {

using testing::CommandOutcome;
using ::testing::HasSubstr;
using testing::run_setsquare;
using testing::TemporaryFolder;

/// The laser sits 0.1 m before the robot's reference.
const Pose2 kMounting{0.1, 0.0, 0.0};
const Pose2 kRobotPoses[] = {{2.0, 2.5, 0.3}, {2.6, 2.2, 0.6}, {2.2, 3.0, -0.4}};

/// A CARMEN log of three scans of one room, and one that saw nothing; stamps 10, 11.5, 12, 13 s.
/// The poses in it are no help: all are the same.
std::string room_log() {
  std::ostringstream log;
  const auto line = [&](const std::vector<double>& ranges_m, const char* stamp) {
    log << "FLASER " << ranges_m.size();
    for (const double range_m : ranges_m) log << ' ' << (std::isfinite(range_m) ? range_m : 81.83);
    log << " 5.1 7 0 5 7 0 " << stamp << " host " << stamp << "\n";
  };
  const testing::Fan fan{180, rad_from_deg(-90), rad_from_deg(1)};
  const std::array stamps{"10.000000", "11.500000", "12.000000"};
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    const Pose2 T_world_sensor = kRobotPoses[i] * kMounting;
    line(testing::scan_of_walls(testing::l_shaped_room(), T_world_sensor, fan).ranges_m, stamps[i]);
  }
  line(std::vector<double>(180, 81.83), "13.000000");
  return log.str();
}

std::string relation(const char* reference, const char* current, const Pose2& T) {
  std::ostringstream line;
  line << reference << ' ' << current << ' ' << T.x_m << ' ' << T.y_m << " 0 0 0 " << T.theta_rad
       << "\n";
  return line.str();
}

Pose2 truth(std::size_t reference, std::size_t current) {
  return kRobotPoses[reference].inverse() * kRobotPoses[current];
}

/// The cells of the lines below the header.
std::vector<std::vector<std::string>> cells_of(const std::string& table) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(table);
  std::string header;
  std::getline(lines, header);
  EXPECT_EQ(header,
            "reference_stamp\tcurrent_stamp\tstatus\tx_m\ty_m\ttheta_rad\tzncc_x\tzncc_y\t"
            "agreement\tcontradiction\toverlap\tscore\trunner_up_score\tprobability\tmicroseconds");
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, '\t');) rows.back().push_back(cell);
  }
  return rows;
}

TEST(CommandMatch, PairsGiveOneLineEachInTheirOrder) {
  const TemporaryFolder folder;
  const std::string log = folder.write("room.clf", room_log());
  const std::string pairs = folder.write("room.relations",
                                         relation("12.000000", "10.000000", truth(2, 0)) +
                                             relation("10.000000", "11.500000", truth(0, 1)) +
                                             relation("10.000000", "13.000000", {}) +
                                             relation("12.000000", "10.000000", truth(2, 0)));
  const CommandOutcome outcome = run_setsquare("match " + log + " --pairs " + pairs);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto rows = cells_of(outcome.out);
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& row : rows) ASSERT_EQ(row.size(), 15U);
  EXPECT_EQ(rows[0][0], "12.000000");
  EXPECT_EQ(rows[0][1], "10.000000");
  EXPECT_EQ(rows[1][0], "10.000000");
  EXPECT_EQ(rows[1][1], "11.500000");
  const std::array truths{truth(2, 0), truth(0, 1)};
  for (std::size_t i = 0; i < truths.size(); ++i) {
    EXPECT_EQ(rows[i][2], "matched");
    EXPECT_NEAR(std::stod(rows[i][3]), truths[i].x_m, 0.03);
    EXPECT_NEAR(std::stod(rows[i][4]), truths[i].y_m, 0.03);
    EXPECT_NEAR(std::stod(rows[i][5]), truths[i].theta_rad, 0.01);
    for (const std::size_t share : {6U, 7U, 8U, 9U, 10U, 11U}) {
      EXPECT_GE(std::stod(rows[i][share]), -1.0);
      EXPECT_LE(std::stod(rows[i][share]), 1.0);
    }
    EXPECT_GT(std::stod(rows[i].back()), 0.0);  // Microseconds.
  }
  EXPECT_EQ(rows[2][2], "too_few_points");
  for (const std::size_t pose : {3U, 4U, 5U}) EXPECT_EQ(rows[2][pose], "nan");
  // The same pair again: the same line but for the time.
  EXPECT_TRUE(std::equal(rows[0].begin(), rows[0].end() - 1, rows[3].begin()));
  EXPECT_THAT(outcome.err, HasSubstr("success"));
  EXPECT_THAT(outcome.err, HasSubstr("all                  4     75.0%"));
}

TEST(CommandMatch, PairsIntoAFileAndBothPresets) {
  const TemporaryFolder folder;
  const std::string log = folder.write("room.clf", room_log());
  const std::string pairs =
      folder.write("room.relations", relation("10.000000", "11.500000", truth(0, 1)));
  for (const std::string preset : {"default", "paper"}) {
    const auto table = folder.path() / (preset + ".tsv");
    const CommandOutcome outcome =
        run_setsquare("match " + log + " --pairs " + pairs + " --preset " + preset + " -o '" +
                      table.string() + "'");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    const auto rows = cells_of(testing::content_of(table));
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].size(), 15U);
    EXPECT_NEAR(std::stod(rows[0][3]), truth(0, 1).x_m, 0.1);
  }
}

TEST(CommandMatch, UnknownStampEndsWithOneLineAndWritesNothing) {
  const TemporaryFolder folder;
  const std::string log = folder.write("room.clf", room_log());
  const std::string pairs = folder.write("room.relations",
                                         relation("10.000000", "11.500000", truth(0, 1)) +
                                             relation("10.000000", "99.000000", truth(0, 1)));
  const auto table = folder.path() / "table.tsv";
  const CommandOutcome outcome =
      run_setsquare("match " + log + " --pairs " + pairs + " -o '" + table.string() + "'");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("99.000000"));
  EXPECT_FALSE(std::filesystem::exists(table));
}

TEST(CommandMatch, UnknownScansEndWithOneLine) {
  const TemporaryFolder folder;
  const std::string log = folder.write("room.clf", room_log());
  for (const char* scans : {"0 4", "7 0", "10.000000 99.5", "0 x", "-1 0", "0"}) {
    const CommandOutcome outcome = run_setsquare("match " + log + " " + scans);
    EXPECT_EQ(outcome.exit_code, 2) << scans;
    EXPECT_EQ(outcome.out, "") << scans;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

TEST(CommandMatch, OptionsThatWouldBeIgnoredAreRefused) {
  const TemporaryFolder folder;
  const std::string log = folder.write("room.clf", room_log());
  const std::string pairs =
      " --pairs " + folder.write("room.relations", relation("10.000000", "11.500000", truth(0, 1)));
  const auto table = folder.path() / "table.tsv";
  for (const std::string& arguments : {pairs + " --json",
                                       pairs + " --frame base",
                                       pairs + " --frame sensor",
                                       " 0 1 -o '" + table.string() + "'",
                                       std::string(" 0 1 -o -"),
                                       std::string(" 0 1 --pairs ''"),
                                       std::string(" --pairs ''")}) {
    const CommandOutcome outcome = run_setsquare("match " + log + arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
  EXPECT_FALSE(std::filesystem::exists(table));
}

TEST(CommandMatch, PairsTakeTheScanNearestToTheirStamp) {
  const TemporaryFolder folder;
  std::string log = room_log();
  std::string nothing_seen = "FLASER 180";
  for (int i = 0; i < 180; ++i) nothing_seen += " 81.83";
  for (const char* const stamp : {"9.999985", "10.000015"}) {
    const std::string line = nothing_seen + " 0 0 0 0 0 0 " + stamp + " host " + stamp + "\n";
    log = stamp[0] == '9' ? line + log : log + line;
  }
  const std::string pairs =
      folder.write("room.relations", relation("10.000000", "11.500000", truth(0, 1)));
  const CommandOutcome outcome =
      run_setsquare("match " + folder.write("room.clf", log) + " --pairs " + pairs);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto rows = cells_of(outcome.out);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0][0], "10.000000");
  EXPECT_EQ(rows[0][2], "matched");
}

TEST(CommandMatch, DamageIsReportedWhetherTheScansAreFoundOrNot) {
  const TemporaryFolder folder;
  const std::string log = folder.write("room.clf", "FLASER 3 1 2\n" + room_log());
  const CommandOutcome found = run_setsquare("match " + log + " 0 1");
  EXPECT_EQ(found.exit_code, 0);
  EXPECT_THAT(found.err, HasSubstr("room.clf: 1 damaged record skipped, at line 1"));
  const CommandOutcome absent = run_setsquare("match " + log + " 0 4");
  EXPECT_EQ(absent.exit_code, 2);
  EXPECT_THAT(absent.err, HasSubstr("beyond the last of its 4 scans, numbered from 0 (1 damaged"));
  EXPECT_EQ(std::count(absent.err.begin(), absent.err.end(), '\n'), 1) << absent.err;
}

TEST(CommandMatch, IndicesAndStampsNameTheSameScans) {
  const TemporaryFolder folder;
  const std::string log = folder.write("room.clf", room_log());
  const CommandOutcome by_index = run_setsquare("match " + log + " 0 1 --json");
  const CommandOutcome by_stamp = run_setsquare("match " + log + " 10.000000 11.5 --json");
  EXPECT_EQ(by_index.exit_code, 0) << by_index.err;
  EXPECT_THAT(by_index.out, HasSubstr("\"matched\""));
  const auto without_time = [](const std::string& json) {
    return json.substr(0, json.find("microseconds"));
  };
  EXPECT_EQ(without_time(by_index.out), without_time(by_stamp.out));
  const CommandOutcome for_people = run_setsquare("match " + log + " 0 1");
  EXPECT_EQ(for_people.exit_code, 0);
  EXPECT_THAT(for_people.out, HasSubstr("matched"));
}

TEST(CommandMatch, ReportsMarginalStandardDeviations) {
  const TemporaryFolder folder;
  const std::string log = folder.write("room.clf", room_log());
  const auto json = nlohmann::json::parse(run_setsquare("match " + log + " 0 1 --json").out);
  Eigen::Matrix3d information;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      information(row, column) = json["information"][row][column].get<double>();
    }
  }
  const Eigen::Matrix3d covariance = information.inverse();
  const double sigma_rad = json["sigma"]["theta_rad"].get<double>();
  EXPECT_NEAR(json["sigma"]["x_m"].get<double>(), std::sqrt(covariance(0, 0)), 1e-9);
  EXPECT_NEAR(json["sigma"]["y_m"].get<double>(), std::sqrt(covariance(1, 1)), 1e-9);
  EXPECT_NEAR(sigma_rad, std::sqrt(covariance(2, 2)), 1e-9);
  std::array<char, 40> heading{};
  std::snprintf(heading.data(), heading.size(), "heading %.3f deg", deg_from_rad(sigma_rad));
  EXPECT_THAT(run_setsquare("match " + log + " 0 1").out, HasSubstr(heading.data()));
}

}  // namespace setsquare::cli_match_test
