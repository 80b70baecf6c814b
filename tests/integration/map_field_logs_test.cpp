// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Logs that the mapper was not built on: wings at odd angles, tracking that slips, a corridor whose
// length one scan after another leaves open. Each with the rule that mends it, and without.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include "setsquare/core/angle.hpp"
#include "setsquare/eval/evaluate.hpp"
#include "setsquare/io/logs/open_log.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "tests/support/data_dir.hpp"

namespace setsquare::map_field_logs_test {

using testing::data_file;

/// Of a log's scans every `stride`-th.
Map map_log(const std::string& path,
            bool uses_odometry,
            const MapperParams& params = {},
            std::size_t stride = 1) {
  Mapper mapper(params);
  const auto reader = open_log(path);
  std::size_t i = 0;
  while (const LogRecord* record = reader->next()) {
    if (i++ % stride != 0) continue;
    mapper.add(record->scan, uses_odometry ? record->T_odom_base : std::nullopt);
  }
  return mapper.finish();
}

/// Mean absolute error against another program's map, good to about 0.05 m over short ways.
double mean_error_m(const Map& map, const std::string& reference_path) {
  Trajectory trajectory;
  for (const MappedScan& scan : map.scans) {
    if (scan.is_placed) trajectory.push_back({scan.stamp, scan.T_map_sensor});
  }
  return evaluate(trajectory, read_trajectory_tum(reference_path)).translation_m.mean;
}

bool has_doubt(const Map& map, DoubtKind kind) {
  return std::any_of(map.doubts.begin(), map.doubts.end(), [&](const MapDoubt& doubt) {
    return doubt.kind == kind;
  });
}

/// A building whose walls are not square throughout.
struct ObliqueLog {
  std::string name;
  double max_error_m = 0.0;
  double min_error_without_m = 0.0;  ///< Where slips are not told from wings by matches.
};

class MapFieldLog : public ::testing::TestWithParam<ObliqueLog> {};

TEST_P(MapFieldLog, WingsAreToldFromSlips) {
  const auto log_path = data_file("field/" + GetParam().name + ".clf");
  const auto reference_path = data_file("field/" + GetParam().name + ".reference.tum");
  if (!log_path || !reference_path) GTEST_SKIP() << "no real logs";
  for (const bool uses_odometry : {true, false}) {
    const Map map = map_log(*log_path, uses_odometry);
    EXPECT_LT(mean_error_m(map, *reference_path), GetParam().max_error_m) << uses_odometry;
    EXPECT_TRUE(map.doubts.empty()) << uses_odometry;
  }
}

/// Nothing tells wings from slips; the maps that come out are not mended by what contradicts them.
MapperParams without_the_rules() {
  MapperParams params;
  params.turns.max_rounds = 0;
  params.turns.unlikely_slip_sigmas = 1e3;
  params.audit.max_mendings = 0;
  return params;
}

TEST_P(MapFieldLog, WithoutTheRulesTheyAreNotAndTheMapSaysSo) {
  const auto log_path = data_file("field/" + GetParam().name + ".clf");
  const auto reference_path = data_file("field/" + GetParam().name + ".reference.tum");
  if (!log_path || !reference_path) GTEST_SKIP() << "no real logs";
  const Map map = map_log(*log_path, true, without_the_rules());
  EXPECT_GT(mean_error_m(map, *reference_path), GetParam().min_error_without_m);
  EXPECT_TRUE(has_doubt(map, DoubtKind::kContradictingPairs));
}

TEST_P(MapFieldLog, WithoutTheMatchesTrackingThatHardlyErrsTellsThem) {
  const auto log_path = data_file("field/" + GetParam().name + ".clf");
  const auto reference_path = data_file("field/" + GetParam().name + ".reference.tum");
  if (!log_path || !reference_path) GTEST_SKIP() << "no real logs";
  MapperParams params = without_the_rules();
  params.turns.unlikely_slip_sigmas = MapperParams().turns.unlikely_slip_sigmas;
  const Map map = map_log(*log_path, true, params);
  EXPECT_LT(mean_error_m(map, *reference_path), GetParam().max_error_m);
}

std::string test_name(const ::testing::TestParamInfo<ObliqueLog>& info) {
  return info.param.name == "csail" ? "csail" : "freiburg101";
}

INSTANTIATE_TEST_SUITE_P(Oblique,
                         MapFieldLog,
                         ::testing::Values(ObliqueLog{"csail", 0.11, 0.13},
                                           ObliqueLog{"freiburg-101", 0.06, 0.5}),
                         test_name);

// With so few scans tracking is so unsure that the oblique wall bends the headings bit by bit, and
// no turn is doubted.
TEST(MapFieldLogs, AWallThatBendsTheHeadingsIsOutvoted) {
  const auto path = data_file("field/freiburg-101.clf");
  const auto reference_path = data_file("field/freiburg-101.reference.tum");
  if (!path || !reference_path) GTEST_SKIP() << "no real logs";
  const Map map = map_log(*path, true, {}, 3);
  EXPECT_LT(mean_error_m(map, *reference_path), 0.08);
  EXPECT_TRUE(map.doubts.empty());
  MapperParams params;
  params.outvoted.is_on = false;
  EXPECT_GT(mean_error_m(map_log(*path, true, params, 3), *reference_path), 0.3);
}

TEST(MapFieldLogs, WhatContradictsACorridorMendsIt) {
  const auto path = data_file("field/mrpt-office.rawlog");
  if (!path) GTEST_SKIP() << "no real logs";
  EXPECT_TRUE(map_log(*path, false).doubts.empty());
  MapperParams params;
  params.audit.max_mendings = 0;
  EXPECT_TRUE(has_doubt(map_log(*path, false, params), DoubtKind::kContradictingPairs));
}

/// Scans of which two maps of a log differ by so much more than what both state: by how the robot
/// turned since the first scan.
std::size_t num_turned_silently(const Map& map, const Map& other) {
  constexpr double kTurned_rad = rad_from_deg(8.0);
  const double offset_rad =
      map.scans.front().T_map_base.theta_rad - other.scans.front().T_map_base.theta_rad;
  std::size_t num = 0;
  for (std::size_t i = 0; i < map.scans.size(); ++i) {
    const MappedScan& a = map.scans[i];
    const MappedScan& b = other.scans[i];
    if (!a.is_placed || a.status == TrackStatus::kLost) continue;
    const double off_rad =
        std::abs(wrap_to_pi(a.T_map_base.theta_rad - b.T_map_base.theta_rad - offset_rad));
    const double sigma_rad = std::hypot(a.heading_sigma_rad, b.heading_sigma_rad);
    num += off_rad > kTurned_rad && off_rad > 3.0 * sigma_rad;
  }
  return num;
}

// A lidar that sees 4 m, in a laboratory full of clutter: scans are pulled aside by up to 28 deg.
TEST(MapFieldLogs, ScansThatAreTurnedByClutterAreUncertain) {
  const auto path = data_file("field/breezy-lab.clf");
  if (!path) GTEST_SKIP() << "no real logs";
  const Map by_odometry = map_log(*path, true);
  // Where scans are turned most no map is right; of the 390 scans before these are a few.
  EXPECT_LT(num_turned_silently(map_log(*path, false), by_odometry), 5U);
  MapperParams params;
  params.tracker.jolts.min_m = params.tracker.jolts.min_rad = 1e3;
  EXPECT_GT(num_turned_silently(map_log(*path, false, params), by_odometry), 100U);
}

TEST(MapFieldLogs, APieceIsJoinedWhereMatchesHaveTheRobotWhereTheWheelsHaveIt) {
  const auto path = data_file("field/mrpt-office.rawlog");
  if (!path) GTEST_SKIP() << "no real logs";
  const Map map = map_log(*path, true);
  EXPECT_TRUE(map.doubts.empty());
  EXPECT_TRUE(std::all_of(map.pieces.begin(), map.pieces.end(), [](const TrackPiece& piece) {
    return piece.is_joined;
  }));
}

}  // namespace setsquare::map_field_logs_test
