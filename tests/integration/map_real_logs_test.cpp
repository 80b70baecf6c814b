// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The mapper on the real logs, against the relations of Kuemmerle et al. 2009: one parameter set,
// with and without odometry.
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "setsquare/eval/chained_reference.hpp"
#include "setsquare/eval/closure_judgement.hpp"
#include "setsquare/eval/relation_error.hpp"
#include "setsquare/io/logs/open_log.hpp"
#include "setsquare/io/tables/relations.hpp"
#include "setsquare/mapping/mapper.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "tests/support/data_dir.hpp"

namespace setsquare::map_real_logs_test {

using testing::data_file;

/// A log with its relations, where they are.
struct Recording {
  std::string log_path;
  std::vector<Relation> relations;
};

std::optional<Recording> recording(const std::string& name) {
  const std::string stem = name + "/" + name;
  const auto log_path = data_file(stem + ".clf");
  const auto relations_path = data_file(stem + ".relations");
  if (!log_path || !relations_path) return std::nullopt;
  return Recording{*log_path, read_relations(*relations_path)};
}

/// Maps a log without the scans [left_out_from, left_out_to).
Map map_log(const std::string& path,
            bool uses_odometry,
            std::size_t num_threads = 1,
            std::size_t left_out_from = 0,
            std::size_t left_out_to = 0) {
  MapperParams params;
  params.num_threads = num_threads;
  Mapper mapper(params);
  const auto reader = open_log(path);
  std::size_t index = 0;
  while (const LogRecord* record = reader->next()) {
    const std::size_t i = index++;
    if (i >= left_out_from && i < left_out_to) continue;
    mapper.add(record->scan, uses_odometry ? record->T_odom_base : std::nullopt);
  }
  return mapper.finish();
}

struct RealLog {
  std::string name;
  bool uses_odometry = true;
  double max_translation_m = 0.0;  ///< Mean, of all relations.
  double max_rotation_deg = 0.0;
  double max_long_m = 0.0;  ///< Mean, of relations 60 s and more apart.
  std::size_t min_judged = 0;
};

std::ostream& operator<<(std::ostream& stream, const RealLog& log) {
  return stream << log.name << (log.uses_odometry ? " with odometry" : " without odometry");
}

std::string test_name(const ::testing::TestParamInfo<RealLog>& info) {
  return info.param.name + (info.param.uses_odometry ? "WithOdometry" : "WithoutOdometry");
}

class MapRealLog : public ::testing::TestWithParam<RealLog> {};

TEST_P(MapRealLog, AgreesWithTheRelationsAndClosesNothingWrongly) {
  const RealLog& log = GetParam();
  const auto data = recording(log.name);
  if (!data) GTEST_SKIP() << log.name << " is not there";
  const Map track = map_log(data->log_path, log.uses_odometry);
  const Trajectory trajectory = trajectory_of(track);

  const RelationErrorReport report = relation_error(trajectory, data->relations);
  EXPECT_EQ(report.num_missing, 0U);
  EXPECT_LE(report.all.translation_m.mean, log.max_translation_m);
  EXPECT_LE(deg_from_rad(report.all.rotation_rad.mean), log.max_rotation_deg);
  EXPECT_LE(report.from_60_s.translation_m.mean, log.max_long_m);

  std::vector<LoopClosure> closures;
  for (const MappedClosure& mapped : track.closures) closures.push_back(mapped.closure);
  const ChainedReference reference(data->relations, trajectory);
  const auto judgements = judge_closures(
      closures,
      [&](Timestamp i, Timestamp j) { return reference.expected(i, j); },
      PoseIndex(trajectory));
  const ClosureSummary summary = summarise_closures(closures, judgements);
  EXPECT_GE(summary.accepted.num_judged(), log.min_judged);
  EXPECT_EQ(summary.accepted.num_wrong, 0U);
}

// A little above the errors when this was written, so that they do not grow again.
INSTANTIATE_TEST_SUITE_P(Logs,
                         MapRealLog,
                         ::testing::Values(RealLog{"intel", true, 0.0140, 0.215, 0.0175, 500},
                                           RealLog{"intel", false, 0.0140, 0.215, 0.0175, 500},
                                           RealLog{"aces", true, 0.0355, 0.310, 0.0530, 40},
                                           RealLog{"aces", false, 0.0360, 0.330, 0.0560, 40},
                                           RealLog{"fr079", true, 0.0325, 0.437, 0.0440, 200},
                                           RealLog{"fr079", false, 0.0325, 0.440, 0.0440, 200}),
                         test_name);

TEST(MapRealLogs, AHoleInTheLogIsBridgedByThePlacesSeenAgain) {
  const auto data = recording("intel");
  if (!data) GTEST_SKIP() << "intel is not there";
  const Map track = map_log(data->log_path, false, 1, 6000, 6600);
  ASSERT_EQ(track.pieces.size(), 2U) << "the motion during a minute is unknown";
  EXPECT_TRUE(track.pieces[0].is_joined && track.pieces[1].is_joined);
  const RelationErrorReport report = relation_error(trajectory_of(track), data->relations);
  EXPECT_LE(report.all.translation_m.mean, 0.0145);
  EXPECT_LE(deg_from_rad(report.all.rotation_rad.mean), 0.225);
}

TEST(MapRealLogs, WhereTheWheelsAreWrongForAScanTheWallsHoldIt) {
  // Mrpt's log of a hall: now and then a scan comes late, and the odometry with it is 0.3 m off.
  const std::string path =
      "/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "mrpt-common is not installed";
  const Map with = map_log(path, true);
  const Map without = map_log(path, false);
  ASSERT_EQ(with.scans.size(), without.scans.size());
  for (std::size_t i = 0; i < with.scans.size(); ++i) {
    EXPECT_EQ(with.scans[i].status, TrackStatus::kTracked) << i;
    EXPECT_LT(
        (with.scans[i].T_map_base.translation() - without.scans[i].T_map_base.translation()).norm(),
        0.1)
        << i;
  }
}

TEST(MapRealLogs, AnyNumberOfThreadsGivesTheSamePoses) {
  const auto data = recording("aces");
  if (!data) GTEST_SKIP() << "aces is not there";
  const Map one = map_log(data->log_path, true, 1);
  const Map three = map_log(data->log_path, true, 3);
  ASSERT_EQ(one.scans.size(), three.scans.size());
  for (std::size_t i = 0; i < one.scans.size(); ++i) {
    ASSERT_EQ(one.scans[i].T_map_base, three.scans[i].T_map_base) << i;
  }
}

}  // namespace setsquare::map_real_logs_test
