// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "setsquare/core/pose2.hpp"
#include "setsquare/io/tables/closures_tsv.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"
#include "tests/integration/run_setsquare.hpp"
#include "tests/support/data_dir.hpp"

namespace setsquare::cli_evaluate_test {

using testing::CommandOutcome;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::run_setsquare;
using ::testing::StartsWith;
using testing::TemporaryFolder;
using Json = nlohmann::json;

/// A robot that drives twice along the same 20 m, 0.1 m per scan, 10 scans per second, looking
/// along the map's y; the second time begins 100 s after the first.
Trajectory two_drives() {
  Trajectory trajectory;
  for (int drive = 0; drive < 2; ++drive) {
    for (int k = 0; k < 200; ++k) {
      trajectory.push_back(
          {timestamp_from_seconds(100.0 * drive + 0.1 * k), {3.0, 0.1 * k, kPi / 2}});
    }
  }
  return trajectory;
}

/// Each fifth scan seen from the one of the other drive, and the next one of its drive.
std::string relations_of(const Trajectory& trajectory) {
  std::string text;
  const auto append = [&](std::size_t a, std::size_t b) {
    const Pose2 T = trajectory[a].pose.inverse() * trajectory[b].pose;
    text += to_string(trajectory[a].stamp) + " " + to_string(trajectory[b].stamp) + " " +
            std::to_string(T.x_m) + " " + std::to_string(T.y_m) + " 0 0 0 " +
            std::to_string(T.theta_rad) + "\n";
  };
  for (std::size_t k = 0; k + 5 < 200; k += 5) {
    append(k, k + 200);
    append(k, k + 5);
    append(k + 200, k + 205);
  }
  return text;
}

/// Scans of the second drive seen from the first: a right one, one 1 m too far ahead (along the
/// map's y), the same one as a closure of x alone, a refused one, one that no reference reaches.
std::vector<LoopClosure> closures() {
  const auto closure = [](int i, int j, double x_m, ClosureAxes axes, bool is_accepted) {
    const auto stamp = [](int k) {
      return timestamp_from_seconds(k < 200 ? 0.1 * k : 80 + 0.1 * k);
    };
    return LoopClosure{stamp(i), stamp(j), {x_m, 0, 0}, axes, is_accepted, 0.8, "of a test"};
  };
  return {closure(11, 213, 0.2, ClosureAxes::kXY, true),
          closure(31, 231, 1.0, ClosureAxes::kXY, true),
          closure(51, 251, 1.0, ClosureAxes::kX, true),
          closure(71, 271, 0.0, ClosureAxes::kXY, false),
          closure(11, 900, 0.0, ClosureAxes::kXY, true)};
}

/// The files of such a run, in a separate folder.
class CommandEvaluateClosures : public ::testing::Test {
 protected:
  void SetUp() override {
    write_trajectory_tum((folder_.path() / "trajectory.tum").string(), two_drives());
    closures_ = folder_.write("closures.tsv", tsv_from_closures(closures()));
    relations_ = folder_.write("true.relations", relations_of(two_drives()));
    truth_ = folder_.write("truth.tum", tum_from_trajectory(two_drives()));
  }

  [[nodiscard]] static Json json_of(const std::string& arguments) {
    const CommandOutcome outcome = run_setsquare("evaluate closures --json " + arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return Json::parse(outcome.out);
  }

  TemporaryFolder folder_;
  std::string closures_;
  std::string relations_;
  std::string truth_;
};

void expect_verdicts(const Json& json) {
  EXPECT_EQ(json["accepted"]["num_closures"], 4);
  EXPECT_EQ(json["accepted"]["num_right"], 2);
  EXPECT_EQ(json["accepted"]["num_wrong"], 1);
  EXPECT_NEAR(json["accepted"]["wrong_share"].get<double>(), 1.0 / 3.0, 1e-12);
  EXPECT_EQ(json["accepted"]["num_unjudged"], 1);
  EXPECT_EQ(json["refused"]["num_right"], 1);
  EXPECT_EQ(json["num_heavy_wrong"], 1);
}

TEST_F(CommandEvaluateClosures, ByRelationsAndByATrueTrajectoryTheVerdictIsTheSame) {
  expect_verdicts(json_of(closures_ + " " + relations_));
  expect_verdicts(json_of(closures_ + " " + truth_));
  expect_verdicts(json_of(closures_ + " " + truth_ + " --reference-kind trajectory"));
}

TEST_F(CommandEvaluateClosures, ListsTheWrongOne) {
  const CommandOutcome table =
      run_setsquare("evaluate closures --list " + closures_ + " " + relations_);
  EXPECT_EQ(table.exit_code, 0) << table.err;
  EXPECT_THAT(table.out, HasSubstr("33.33 %"));
  EXPECT_THAT(table.out, HasSubstr("weight above 0.3: 1"));
  EXPECT_THAT(table.out,
              HasSubstr("\n3.100000\t103.100000\twrong\t1.000\t0.000\txy\t0.800\tof a test\n"));
  EXPECT_THAT(table.out, Not(HasSubstr("5.100000\t")));
  const Json json = json_of("--list " + closures_ + " " + truth_);
  ASSERT_EQ(json["doubtful"].size(), 1U);
  EXPECT_EQ(json["doubtful"][0]["stamp_j"], "103.100000");
  EXPECT_NEAR(json["doubtful"][0]["translation_error_m"].get<double>(), 1.0, 1e-6);
}

TEST_F(CommandEvaluateClosures, TheTrajectoryMayLieElsewhere) {
  std::filesystem::create_directory(folder_.path() / "alone");
  const std::string moved = folder_.write("alone/closures.tsv", tsv_from_closures(closures()));
  const CommandOutcome missing = run_setsquare("evaluate closures " + moved + " " + relations_);
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_THAT(missing.err, HasSubstr("alone/trajectory.tum: No such file"));
  expect_verdicts(json_of(moved + " " + relations_ + " --trajectory " + truth_));
  const Json without_headings = json_of(moved + " " + truth_);
  EXPECT_EQ(without_headings["accepted"]["num_unjudged"], 2) << "that of a single axis, too";
}

TEST_F(CommandEvaluateClosures, FilesThatDoNotBelongTogetherAreRefusedInOneLine) {
  const std::string other_relations = folder_.write("o.relations", "7000 8000 1 0 0 0 0 0\n");
  const std::string other_truth = folder_.write("o.tum", "7000 1 0 0 0 0 0 1\n");
  const std::string odd =
      folder_.write("odd", "1 0 0 0 0 0 0 1\n2 0 0 0 0 0 0 1\n3 0 0 0 0 0 0 2\n");
  for (const auto& [arguments, expected] : std::vector<std::pair<std::string, std::string>>{
           {closures_ + " " + other_relations, "o.relations: no line has both its stamps"},
           {closures_ + " " + other_truth, "closures.tsv: no line has both its stamps"},
           {closures_ + " " + odd, "odd: neither relations nor a trajectory for sure"},
           {closures_ + " -", "say --reference-kind"},
           {closures_ + " " + closures_, "closures.tsv, line 1: expected eight numbers"},
           {truth_ + " " + relations_, "truth.tum, line 1: expected the header"},
           {closures_ + " " + relations_ + " --reference-kind map", "--reference-kind"}}) {
    const CommandOutcome outcome = run_setsquare("evaluate closures " + arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_THAT(outcome.err, StartsWith("setsquare: "));
    EXPECT_THAT(outcome.err, HasSubstr(expected));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

TEST_F(CommandEvaluateClosures, AMapWithoutClosuresHasNoShareOfWrongOnes) {
  const std::string none = folder_.write("none.tsv", tsv_from_closures({}));
  EXPECT_TRUE(json_of(none + " " + relations_)["accepted"]["wrong_share"].is_null());
  EXPECT_THAT(run_setsquare("evaluate closures " + none + " " + relations_).out, HasSubstr(" - "));
}

TEST(CommandEvaluateChains, ShowWhetherTheVerdictsAreReliable) {
  const TemporaryFolder folder;
  const std::string relations = folder.write("true.relations", relations_of(two_drives()));
  const CommandOutcome outcome = run_setsquare("evaluate chains --json " + relations);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["num_closures"], 39);
  EXPECT_EQ(json["num_right"], 39);
  EXPECT_LT(json["translation_m"]["max"], 1e-5);
  EXPECT_THAT(run_setsquare("evaluate chains " + relations).out, HasSubstr("39 relations"));
}

// The second trajectory lies elsewhere, in another order, and is 0.1 m off along its way.
TEST(CommandEvaluateTrajectory, AbsoluteAndRelativeErrors) {
  const TemporaryFolder folder;
  const Trajectory truth = two_drives();
  Trajectory judged(truth.rbegin(), truth.rend());
  for (StampedPose& stamped : judged) {
    if (stamped.stamp.seconds() >= 100.0) stamped.pose.x_m += 0.1;
    stamped.pose = Pose2{-4, 2, 1.0} * stamped.pose;
  }
  const std::string files = folder.write("judged.tum", tum_from_trajectory(judged)) + " " +
                            folder.write("truth.tum", tum_from_trajectory(truth));
  const CommandOutcome ate = run_setsquare("evaluate ate --json " + files);
  ASSERT_EQ(ate.exit_code, 0) << ate.err;
  const Json best = Json::parse(ate.out);
  EXPECT_EQ(best["num_pairs"], 400);
  EXPECT_NEAR(best["translation_m"]["mean"].get<double>(), 0.05, 1e-3);
  const Json first = Json::parse(run_setsquare("evaluate ate --json --align first " + files).out);
  EXPECT_NEAR(first["translation_m"]["mean"].get<double>(), 0.05, 1e-5);
  EXPECT_NEAR(first["translation_m"]["max"].get<double>(), 0.1, 1e-5);
  EXPECT_NEAR(first["final"]["translation_m"].get<double>(), 0.1, 1e-5);
  const Json none = Json::parse(run_setsquare("evaluate ate --json --align none " + files).out);
  EXPECT_GT(none["translation_m"]["mean"], 1.0);
  EXPECT_NEAR(none["rotation_deg"]["mean"].get<double>(), deg_from_rad(1.0), 1e-5);
  const Json rpe = Json::parse(run_setsquare("evaluate rpe --json " + files).out);
  // 190 spans of 1 m on each drive; between them the reference jumps back 19.9 m.
  EXPECT_EQ(rpe["num_spans"], 380);
  EXPECT_EQ(rpe["num_left_out"], 10);
  EXPECT_LT(rpe["translation_m"]["max"], 1e-5);
  const Json over_time =
      Json::parse(run_setsquare("evaluate rpe --json --delta-s 100 " + files).out);
  EXPECT_EQ(over_time["num_spans"], 200);
  EXPECT_NEAR(over_time["translation_m"]["mean"].get<double>(), 0.1, 1e-5);
  EXPECT_THAT(run_setsquare("evaluate ate " + files).out, HasSubstr("rotation, deg"));
  EXPECT_THAT(run_setsquare("evaluate rpe --delta-poses 3 " + files).out, HasSubstr("397 spans"));
}

/// A judged trajectory, whose second drive is 0.1 m off, and its truth.
class CommandEvaluateFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    Trajectory judged = two_drives();
    for (StampedPose& stamped : judged) {
      if (stamped.stamp.seconds() >= 100.0) stamped.pose.x_m += 0.1;
      stamped.pose = Pose2{-4, 2, 1.0} * stamped.pose;
    }
    judged_ = folder_.write("judged.tum", tum_from_trajectory(judged));
    truth_ = folder_.write("truth.tum", tum_from_trajectory(two_drives()));
    relations_ = folder_.write("true.relations", relations_of(two_drives()));
  }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_.path() / name).string();
  }

  [[nodiscard]] std::string bytes_of(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    EXPECT_TRUE(file) << name;
    return {std::istreambuf_iterator<char>(file), {}};
  }

  [[nodiscard]] CommandOutcome evaluate(const std::string& arguments) const {
    CommandOutcome outcome = run_setsquare("evaluate " + arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome;
  }

  TemporaryFolder folder_;
  std::string judged_;
  std::string truth_;
  std::string relations_;
};

std::size_t num_lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST_F(CommandEvaluateFiles, TheAlignedTrajectoriesHaveTheErrorThatWasPrinted) {
  const Json json =
      Json::parse(evaluate("ate --json " + judged_ + " " + truth_ + " -o " + path("results")).out);
  EXPECT_EQ(Json::parse(bytes_of("results/ate.json")), json);
  const Trajectory aligned = read_trajectory_tum(path("results/aligned.tum"));
  const Trajectory reference = read_trajectory_tum(path("results/reference.tum"));
  ASSERT_EQ(aligned.size(), 400U);
  ASSERT_EQ(reference.size(), 400U);
  std::istringstream aligned_rows(bytes_of("results/aligned.kitti"));
  std::istringstream reference_rows(bytes_of("results/reference.kitti"));
  double by_tum = 0.0;
  double by_kitti = 0.0;
  for (std::size_t i = 0; i < aligned.size(); ++i) {
    ASSERT_EQ(aligned[i].stamp, reference[i].stamp);
    by_tum += (aligned[i].pose.translation() - reference[i].pose.translation()).squaredNorm();
    std::array<double, 12> a{};
    std::array<double, 12> b{};
    for (std::size_t k = 0; k < 12; ++k)
      ASSERT_TRUE(aligned_rows >> a[k] && reference_rows >> b[k]);
    by_kitti += std::pow(a[3] - b[3], 2) + std::pow(a[7] - b[7], 2);
  }
  const auto rmse = json["translation_m"]["rmse"].get<double>();
  EXPECT_NEAR(std::sqrt(by_tum / 400.0), rmse, 1e-5);
  EXPECT_NEAR(std::sqrt(by_kitti / 400.0), rmse, 1e-5);
  EXPECT_EQ(num_lines(bytes_of("results/ate_errors.tsv")), 401U);
  EXPECT_EQ(num_lines(bytes_of("results/ate.tsv")), 3U);
  EXPECT_THAT(bytes_of("results/ate_errors.svg"), HasSubstr("</svg>"));
  EXPECT_THAT(bytes_of("results/ate_trajectories.svg"), HasSubstr("</svg>"));
}

TEST_F(CommandEvaluateFiles, BoundsLieAboutTheFiguresAndAreAlwaysTheSame) {
  const std::string command = "ate " + judged_ + " " + truth_ + " --align none --bootstrap 100";
  const Json error = Json::parse(evaluate(command + " --json").out)["translation_m"];
  EXPECT_LT(error["bounds"]["mean"][0], error["mean"]);
  EXPECT_GT(error["bounds"]["mean"][1], error["mean"]);
  EXPECT_GT(error["bounds"]["block_length"], 1);
  const std::string table = evaluate(command).out;
  EXPECT_THAT(table, HasSubstr("from 5 %"));
  EXPECT_THAT(table, HasSubstr("block bootstrap"));
  EXPECT_EQ(table, evaluate(command).out);
  EXPECT_THAT(evaluate("ate " + judged_ + " " + truth_).out, Not(HasSubstr("from 5 %")));
}

TEST_F(CommandEvaluateFiles, SpansAndRelationsAreWrittenBesideThem) {
  const std::string into = " -o " + path("results");
  EXPECT_THAT(evaluate("ate " + judged_ + " " + truth_ + into).out, HasSubstr("aligned.kitti"));
  EXPECT_THAT(evaluate("rpe " + judged_ + " " + truth_ + into).out, HasSubstr("rpe_errors.svg"));
  EXPECT_EQ(num_lines(bytes_of("results/rpe_errors.tsv")), 381U);
  const CommandOutcome relations = evaluate("relations " + judged_ + " " + relations_ + into);
  EXPECT_THAT(relations.out, HasSubstr("means, from 5 to 95 %"));
  const Json json = Json::parse(bytes_of("results/relations.json"));
  const Json& error = json["from_60_s"]["translation_m"];
  EXPECT_LE(error["mean_bound"][0], error["mean"]);
  EXPECT_GE(error["mean_bound"][1], error["mean"]);
  EXPECT_EQ(num_lines(bytes_of("results/relations.tsv")), 4U);
  EXPECT_EQ(num_lines(bytes_of("results/relations_errors.tsv")), 1U + 39U * 3U);
  EXPECT_EQ(num_lines(bytes_of("results/ate_errors.tsv")), 401U) << "the first ones stay";
}

TEST_F(CommandEvaluateFiles, NothingIsWrittenOntoAnInput) {
  static_cast<void>(evaluate("ate " + judged_ + " " + truth_ + " -o " + path("results")));
  const std::string before = bytes_of("results/aligned.tum");
  const CommandOutcome outcome = run_setsquare("evaluate ate " + path("results/aligned.tum") + " " +
                                               truth_ + " -o " + path("results"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("aligned.tum"));
  EXPECT_EQ(bytes_of("results/aligned.tum"), before);
  EXPECT_EQ(run_setsquare("evaluate ate " + judged_ + " " + truth_ + " --bootstrap 3").exit_code,
            2);
}

TEST(CommandEvaluateTrajectory, WhatCannotBeComparedIsRefusedInOneLine) {
  const TemporaryFolder folder;
  const std::string truth = folder.write("truth.tum", tum_from_trajectory(two_drives()));
  const std::string later = folder.write("later.tum", "5000 1 0 0 0 0 0 1\n");
  const std::string damaged = folder.write("damaged.tum", "1 1 0 0 0 0 0 1\n2 0\n");
  for (const auto& [arguments, expected] : std::vector<std::pair<std::string, std::string>>{
           {"ate " + truth + " " + later, "later.tum: no pose at the time of one in"},
           {"ate " + damaged + " " + truth, "damaged.tum, line 2: expected"},
           {"ate " + truth + " " + truth + " --align last", "--align"},
           {"ate " + truth, "reference is required"},
           {"rpe " + truth + " " + truth + " --delta-m 5000", "no two paired poses"},
           {"rpe " + truth + " " + truth + " --delta-m -1", "--delta-m"},
           {"rpe " + truth + " " + truth + " --delta-m 1 --delta-s 1", "excludes"},
           {"rpe " + truth + " " + truth + " --max-time-difference -1", "--max-time-difference"}}) {
    const CommandOutcome outcome = run_setsquare("evaluate " + arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_THAT(outcome.err, HasSubstr(expected));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

TEST(CommandEvaluateRealRelations, ChainsPredictRelationsThatTheyDoNotContain) {
  for (const std::string log : {"intel", "aces", "fr079"}) {
    const auto relations = testing::data_file(log + "/" + log + ".relations");
    if (!relations) GTEST_SKIP() << "no data folder";
    const CommandOutcome outcome =
        run_setsquare("evaluate chains --json '" + relations->string() + "'");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json json = Json::parse(outcome.out);
    EXPECT_GT(json["num_right"].get<double>(), 0.8 * json["num_closures"].get<double>()) << log;
    EXPECT_EQ(json["num_wrong"], 0) << log;
  }
}

TEST(CommandEvaluate, WhatCouldNotBeMeasuredIsADashOrAnError) {
  const TemporaryFolder folder;
  const std::string trajectory = folder.write("t.tum", "1.0 0 0 0 0 0 0 1\n2.0 1 0 0 0 0 0 1\n");
  const std::string relations = folder.write("x.relations", "1.0 2.0 1 0 0 0 0 0\n");
  const std::string arguments = "evaluate relations " + trajectory + " " + relations;
  const Json json = Json::parse(run_setsquare(arguments + " --json").out);
  EXPECT_EQ(json["under_60_s"]["num_relations"], 1);
  EXPECT_EQ(json["from_60_s"]["num_relations"], 0);
  EXPECT_TRUE(json["from_60_s"]["translation_m"].is_null());
  const CommandOutcome table = run_setsquare(arguments);
  const std::string last = table.out.substr(table.out.find("60 s and more"));
  EXPECT_THAT(last, HasSubstr(" - "));
  EXPECT_THAT(last, Not(HasSubstr("0.0")));

  const CommandOutcome chains = run_setsquare("evaluate chains " + relations);
  EXPECT_EQ(chains.exit_code, 2);
  EXPECT_EQ(chains.out, "");
  EXPECT_THAT(chains.err, HasSubstr("x.relations: no relation between stamps"));
}

}  // namespace setsquare::cli_evaluate_test
