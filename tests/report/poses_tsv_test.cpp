// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/poses_tsv.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "setsquare/core/angle.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::poses_tsv_test {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

/// Rows by the names of their columns, as a script reads them.
using Row = std::map<std::string, std::string>;
std::vector<Row> rows_of(const std::string& text) {
  const std::vector<std::string> lines = split(text, '\n');
  const std::vector<std::string> names = split(lines.at(0), '\t');
  std::vector<Row> rows;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> fields = split(lines[i], '\t');
    EXPECT_EQ(fields.size(), names.size()) << lines[i];
    Row row;
    for (std::size_t k = 0; k < std::min(fields.size(), names.size()); ++k) {
      row[names[k]] = fields[k];
    }
    rows.push_back(row);
  }
  return rows;
}

double number(const Row& row, const std::string& column) { return std::stod(row.at(column)); }

/// Scans of one piece that are well known.
Map well_known_map(std::size_t num_scans) {
  Map map;
  map.pieces = {{0, num_scans, true}};
  for (std::size_t i = 0; i < num_scans; ++i) {
    MappedScan scan;
    scan.stamp = Timestamp{static_cast<std::int64_t>(i) * 100'000'000};
    scan.position_covariance_m2 = 1e-4 * Eigen::Matrix2d::Identity();
    scan.heading_sigma_rad = rad_from_deg(0.2);
    map.scans.push_back(scan);
  }
  return map;
}

TEST(PosesTsv, HasTheColumnsOfTheDocsAndNoRowWithoutAScan) {
  EXPECT_EQ(poses_tsv({}),
            "stamp\tx_m\ty_m\theading_deg\tsigma_x_m\tsigma_y_m\tcorrelation_xy\t"
            "sigma_heading_deg\tstatus\tpiece\tplaced\tdoubts\n");
}

TEST(PosesTsv, NumbersReadBackToTheirDigits) {
  std::mt19937_64 generator = testing::make_generator();
  Map map = well_known_map(200);
  for (MappedScan& scan : map.scans) {
    const auto draw = [&](double most) { return testing::uniform(generator, -most, most); };
    scan.T_map_base = {draw(1e3), draw(1e3), draw(10.0)};
    Eigen::Matrix2d root_m;
    root_m << draw(2.0), draw(2.0), draw(2.0), draw(2.0);
    scan.position_covariance_m2 = root_m * root_m.transpose() + 1e-2 * Eigen::Matrix2d::Identity();
    scan.heading_sigma_rad = std::abs(draw(1.8));
  }
  const std::vector<Row> rows = rows_of(poses_tsv(map));
  ASSERT_EQ(rows.size(), map.scans.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const MappedScan& scan = map.scans[i];
    EXPECT_EQ(rows[i].at("stamp"), to_string(scan.stamp));
    EXPECT_NEAR(number(rows[i], "x_m"), scan.T_map_base.x_m, 1e-6);
    EXPECT_NEAR(number(rows[i], "y_m"), scan.T_map_base.y_m, 1e-6);
    const double heading_rad = rad_from_deg(number(rows[i], "heading_deg"));
    EXPECT_NEAR(wrap_to_pi(heading_rad - scan.T_map_base.theta_rad), 0.0, rad_from_deg(1e-5));
    EXPECT_LE(std::abs(heading_rad), kPi + 1e-6);
    EXPECT_NEAR(rad_from_deg(number(rows[i], "sigma_heading_deg")),
                scan.heading_sigma_rad,
                rad_from_deg(1e-3));
    const double x_m = number(rows[i], "sigma_x_m");
    const double y_m = number(rows[i], "sigma_y_m");
    const Eigen::Matrix2d& covariance_m2 = scan.position_covariance_m2;
    EXPECT_NEAR(x_m * x_m, covariance_m2(0, 0), 2e-4 * x_m);
    EXPECT_NEAR(y_m * y_m, covariance_m2(1, 1), 2e-4 * y_m);
    EXPECT_NEAR(number(rows[i], "correlation_xy") * x_m * y_m, covariance_m2(0, 1), 2e-3);
  }
}

TEST(PosesTsv, HasTheSensorsPoseWhereAskedFor) {
  Map map = well_known_map(1);
  map.scans[0].T_map_base = {1.0, 2.0, 0.0};
  map.scans[0].T_map_sensor = {1.5, 2.0, kPi / 2.0};
  EXPECT_EQ(number(rows_of(poses_tsv(map)).at(0), "x_m"), 1.0);
  const Row of_sensor = rows_of(poses_tsv(map, PoseOf::kSensor)).at(0);
  EXPECT_EQ(number(of_sensor, "x_m"), 1.5);
  EXPECT_EQ(number(of_sensor, "heading_deg"), 90.0);
}

TEST(PosesTsv, AScanOfAPieceThatIsNotJoinedHasItsRow) {
  Map map = well_known_map(5);
  map.pieces = {{0, 3, true}, {3, 2, false}};
  for (std::size_t i = 3; i < 5; ++i) {
    map.scans[i].is_placed = false;
    map.scans[i].position_sigma_m = map.scans[i].heading_sigma_rad = kInfinite;
    // As pose_spreads() leaves it, and what a product of infinities leaves.
    map.scans[i].position_covariance_m2 = kInfinite * Eigen::Matrix2d::Identity();
  }
  const std::vector<Row> rows = rows_of(poses_tsv(map));
  ASSERT_EQ(rows.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    const bool is_placed = i < 3;
    EXPECT_EQ(rows[i].at("placed"), is_placed ? "1" : "0");
    EXPECT_EQ(rows[i].at("piece"), is_placed ? "1" : "2");
    EXPECT_EQ(rows[i].at("doubts"), is_placed ? "-" : "not_joined");
    EXPECT_EQ(std::isinf(number(rows[i], "sigma_x_m")), !is_placed);
    EXPECT_EQ(std::isinf(number(rows[i], "sigma_y_m")), !is_placed);
    EXPECT_EQ(std::isinf(number(rows[i], "sigma_heading_deg")), !is_placed);
    EXPECT_EQ(number(rows[i], "correlation_xy"), 0.0);
  }
}

TEST(PosesTsv, WithoutAGraphSpreadsAreNotANumberAndNothingIsDoubted) {
  Map map;
  map.scans.resize(2);
  for (const Row& row : rows_of(poses_tsv(map))) {
    EXPECT_EQ(row.at("sigma_x_m"), "nan");
    EXPECT_EQ(row.at("sigma_y_m"), "nan");
    EXPECT_EQ(row.at("sigma_heading_deg"), "nan");
    EXPECT_EQ(number(row, "correlation_xy"), 0.0);
    EXPECT_EQ(row.at("doubts"), "-");
    EXPECT_EQ(row.at("piece"), "1") << "a map without pieces is one";
  }
}

TEST(PosesTsv, ACorrelationIsOneAtMost) {
  Map map = well_known_map(3);
  map.scans[0].position_covariance_m2 << 1.0, 1.0 + 1e-9, 1.0 + 1e-9, 1.0;
  map.scans[1].position_covariance_m2 << 1.0, -2.0, -2.0, 1.0;  // No covariance: noise of sums.
  map.scans[2].position_covariance_m2.setZero();                // The first keyframe's.
  const std::vector<Row> rows = rows_of(poses_tsv(map));
  EXPECT_EQ(number(rows.at(0), "correlation_xy"), 1.0);
  EXPECT_EQ(number(rows.at(1), "correlation_xy"), -1.0);
  EXPECT_EQ(number(rows.at(2), "correlation_xy"), 0.0);
  EXPECT_EQ(number(rows.at(2), "sigma_x_m"), 0.0);
}

TEST(PosesTsv, NamesWhatIsDoubted) {
  Map map = well_known_map(6);
  map.scans[1].status = TrackStatus::kLost;
  map.scans[2].heading_sigma_rad = 1.01 * kOpenHeading_rad;
  map.scans[3].heading_sigma_rad = 0.99 * kOpenHeading_rad;
  map.scans[5].status = TrackStatus::kLost;
  map.scans[5].heading_sigma_rad = 1.8;
  map.open_stretches = {{.first_scan = 4, .num_scans = 2}};
  const std::vector<Row> rows = rows_of(poses_tsv(map));
  ASSERT_EQ(rows.size(), 6U);
  const std::vector<std::string> expected = {
      "-", "lost", "heading_open", "-", "length_open", "lost,length_open,heading_open"};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(rows[i].at("doubts"), expected[i]) << i;
    EXPECT_EQ(rows[i].at("status"), to_string(map.scans[i].status)) << i;
  }
}

TEST(PosesTsv, AnOpenTurnIsNoOpenLengthAndHidesNone) {
  Map map = well_known_map(6);
  map.open_stretches = {{.first_scan = 0, .num_scans = 4},
                        {.first_scan = 2, .num_scans = 4, .is_turn = true}};
  const std::vector<Row> rows = rows_of(poses_tsv(map));
  ASSERT_EQ(rows.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(rows[i].at("doubts"), i < 4 ? "length_open" : "-") << i;
  }
}

TEST(PosesTsv, StretchesAndPiecesThatEndBehindTheLastScanDoNoHarm) {
  Map map = well_known_map(2);
  map.pieces = {{0, 1, true}, {1, 9, true}};
  map.open_stretches = {{.first_scan = 1, .num_scans = 9}, {.first_scan = 7, .num_scans = 1}};
  const std::vector<Row> rows = rows_of(poses_tsv(map));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1].at("piece"), "2");
  EXPECT_EQ(rows[0].at("doubts"), "-");
  EXPECT_EQ(rows[1].at("doubts"), "length_open");
}

}  // namespace setsquare::poses_tsv_test
