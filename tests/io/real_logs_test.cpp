// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Facts of real logs. The CARMEN logs skip where the data folder is absent; the rawlog is the one
// of Debian's package mrpt-common.
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>

#include "setsquare/io/logs/log_survey.hpp"
#include "setsquare/io/logs/open_log.hpp"
#include "setsquare/io/tables/relations.hpp"
#include "tests/support/data_dir.hpp"
#include "tests/support/pose_matchers.hpp"

namespace setsquare::real_logs_test {

struct LogFacts {
  std::string file;
  std::string sensor;
  std::uint64_t num_scans;
  double num_beams_low;
  double num_beams_high;
  std::uint64_t num_backward;
  std::uint64_t num_no_returns;
  double path_m;
  Pose2 T_base_sensor;
  std::uint64_t num_sign_contradictions;
};

class RealLog : public ::testing::TestWithParam<LogFacts> {};

TEST_P(RealLog, HoldsWhatIsKnownOfIt) {
  const LogFacts& facts = GetParam();
  const auto path = testing::data_file(facts.file);
  if (!path) GTEST_SKIP() << "no data folder: " << facts.file;
  LogOptions options;
  options.scans_only = false;
  const auto reader = open_log(path->string(), options);
  LogSurvey survey;
  while (const LogRecord* record = reader->next()) survey.add(*record);
  ASSERT_EQ(survey.sensors.size(), 1U);
  const SensorSurvey& sensor = survey.sensors.at(facts.sensor);
  EXPECT_EQ(sensor.stamps.num_stamps, facts.num_scans);
  EXPECT_EQ(sensor.num_beams.low, facts.num_beams_low);
  EXPECT_EQ(sensor.num_beams.high, facts.num_beams_high);
  EXPECT_EQ(sensor.stamps.num_backward, facts.num_backward);
  EXPECT_EQ(sensor.stamps.num_repeated, 0U);
  EXPECT_EQ(sensor.num_no_returns, facts.num_no_returns);
  EXPECT_NEAR(survey.scan_odometry.at(facts.sensor).path_m, facts.path_m, 0.6);
  EXPECT_THAT(sensor.T_base_sensor,
              testing::PoseNear(facts.T_base_sensor, testing::PoseTolerance{}));
  EXPECT_EQ(survey.wheel_odometry.num_sign_contradictions, facts.num_sign_contradictions);
  EXPECT_TRUE(reader->problems().empty());
}

INSTANTIATE_TEST_SUITE_P(
    Carmen,
    RealLog,
    ::testing::Values(
        LogFacts{"intel/intel.clf", "FLASER", 13631, 180, 180, 631, 68313, 508.0, {}, 0},
        LogFacts{"aces/aces.clf", "FLASER", 7374, 180, 180, 0, 11139, 325.0, {}, 0},
        LogFacts{"fr079/fr079.clf", "FLASER", 4934, 360, 360, 0, 36881, 392.0, {-0.04, 0, 0}, 322},
        LogFacts{"fr-clinic/fr-clinic.clf",
                 "ROBOTLASER1",
                 6917,
                 180,
                 181,
                 0,
                 155915,
                 1402.0,
                 {0.22, 0, 0},
                 0}),
    [](const auto& parameter) {
      std::string name = parameter.param.file.substr(0, parameter.param.file.find('/'));
      std::erase(name, '-');
      return name;
    });

TEST(RealRelations, HaveTheKnownNumberOfLines) {
  for (const auto& [file, count] : {std::pair{"intel/intel.relations", 2984U},
                                    {"aces/aces.relations", 1279U},
                                    {"fr079/fr079.relations", 1685U}}) {
    const auto path = testing::data_file(file);
    if (!path) GTEST_SKIP() << "no data folder: " << file;
    EXPECT_EQ(read_relations(path->string()).size(), count) << file;
  }
}

// The figures stand for what MRPT's own library reads from the file.
TEST(RealRawlog, TelecomFaculty) {
  const std::string path =
      "/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "mrpt-common is not installed";
  const auto reader = open_log(path);
  LogSurvey survey;
  std::optional<Pose2> last_T_odom_base;
  while (const LogRecord* record = reader->next()) {
    survey.add(*record);
    last_T_odom_base = record->T_odom_base;
  }
  const SensorSurvey& sensor = survey.sensors.at("laser");
  EXPECT_EQ(sensor.stamps.num_stamps, 225U);
  EXPECT_EQ(sensor.num_beams.low, 361.0);
  EXPECT_EQ(sensor.num_beams.high, 361.0);
  EXPECT_NEAR(sensor.field_of_view_rad.high, kPi, 1e-6);
  EXPECT_GT(sensor.bearing_step_rad.low, 0.0);
  EXPECT_EQ(sensor.max_range_m, 80.0);
  EXPECT_THAT(sensor.T_base_sensor,
              testing::PoseNear(Pose2{0.78, 0.0, 0.0}, testing::PoseTolerance{1e-6, 1e-6}));
  EXPECT_EQ(to_string(sensor.stamps.first), "1137834225.713386");
  EXPECT_EQ(to_string(sensor.stamps.previous), "1137834284.788331");
  ASSERT_TRUE(last_T_odom_base);
  EXPECT_THAT(
      *last_T_odom_base,
      testing::PoseNear(Pose2{-4.80244, -21.16370, -1.86234}, testing::PoseTolerance{1e-5, 1e-5}));
  EXPECT_TRUE(reader->problems().empty());
}

}  // namespace setsquare::real_logs_test
