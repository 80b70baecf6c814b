// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The mapper on the real logs, against the relations of Kuemmerle et al. 2009: one parameter set,
// with and without odometry, no loop closing.
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "setsquare/eval/relation_error.hpp"
#include "setsquare/io/open_log.hpp"
#include "setsquare/io/relations.hpp"
#include "setsquare/slam/mapper.hpp"
#include "tests/support/data_dir.hpp"

namespace setsquare {
namespace {

using testing::data_file;

struct RealLog {
  std::string name;
  bool uses_odometry = true;
  double max_translation_m = 0.0;  ///< Mean, of relations under 60 s apart.
  double max_rotation_deg = 0.0;   ///< Mean, of all relations.
};

std::string test_name(const ::testing::TestParamInfo<RealLog>& info) {
  return info.param.name + (info.param.uses_odometry ? "WithOdometry" : "WithoutOdometry");
}

class MapRealLogs : public ::testing::TestWithParam<RealLog> {};

TEST_P(MapRealLogs, AgreesWithTheRelations) {
  const RealLog& log = GetParam();
  const std::string stem = log.name + "/" + log.name;
  const auto log_path = data_file(stem + ".clf");
  const auto relations_path = data_file(stem + ".relations");
  if (!log_path || !relations_path) GTEST_SKIP() << stem << ".clf is not there";

  Mapper mapper;
  const auto reader = open_log(*log_path);
  while (const LogRecord* record = reader->next()) {
    mapper.add(record->scan, log.uses_odometry ? record->T_odom_base : std::nullopt);
  }
  const MappedTrack track = mapper.finish();
  Trajectory trajectory;
  std::size_t num_lost = 0;
  for (const MappedScan& scan : track.scans) {
    trajectory.push_back({scan.stamp, scan.T_map_base});
    num_lost += scan.status == TrackStatus::kLost;
  }
  const RelationErrorReport report = relation_error(trajectory, read_relations(*relations_path));
  RecordProperty("under_60_s_m", std::to_string(report.under_60_s.translation_m.mean));
  RecordProperty("all_deg", std::to_string(deg_from_rad(report.all.rotation_rad.mean)));
  EXPECT_EQ(report.num_missing, 0U);
  EXPECT_LE(report.under_60_s.translation_m.mean, log.max_translation_m);
  EXPECT_LE(deg_from_rad(report.all.rotation_rad.mean), log.max_rotation_deg);
  EXPECT_LE(num_lost, track.scans.size() / 1000);
}

// A little above what was reached when this was written: no way back.
INSTANTIATE_TEST_SUITE_P(Logs,
                         MapRealLogs,
                         ::testing::Values(RealLog{"intel", true, 0.0120, 0.24},
                                           RealLog{"intel", false, 0.0122, 0.24},
                                           RealLog{"aces", true, 0.0350, 0.32},
                                           RealLog{"aces", false, 0.0360, 0.34},
                                           RealLog{"fr079", true, 0.0295, 0.46},
                                           RealLog{"fr079", false, 0.0295, 0.47}),
                         test_name);

}  // namespace
}  // namespace setsquare
