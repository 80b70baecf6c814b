// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "experiments/building_study.hpp"
#include "experiments/paper_experiment.hpp"
#include "setsquare/core/error.hpp"

namespace setsquare::experiments::experiment_pairs_test {

MatchResult matched_at(const Pose2& pose) {
  MatchResult result;
  result.status = MatchStatus::kMatched;
  result.T_reference_current = pose;
  result.information = Eigen::Vector3d(100.0, 100.0, 400.0).asDiagonal();
  return result;
}

TEST(Judge, ErrorsAreTheAnswersLessTheTruthInTheReferencesFrame) {
  const PairAnswer answer = judge(matched_at({1.1, 2.0, kPi - 0.01}), {1.0, 2.0, 0.02 - kPi});
  EXPECT_NEAR(answer.error.x(), 0.1, 1e-12);
  EXPECT_NEAR(answer.error.z(), -0.03, 1e-12) << "wrapped";
  ASSERT_TRUE(answer.nees.has_value());
  EXPECT_NEAR(*answer.nees, 100.0 * 0.01 + 400.0 * 0.0009, 1e-9);
  EXPECT_TRUE(answer.is_success());
  EXPECT_FALSE(answer.is_wrong());
}

TEST(Judge, ARightPoseMayBeAWrongAnswer) {
  const PairAnswer turned = judge(matched_at({0.0, 0.0, rad_from_deg(10.0)}), {});
  EXPECT_TRUE(turned.is_success()) << "the paper's limit is 30 deg";
  EXPECT_TRUE(turned.is_wrong()) << "ours is 3 deg";
}

TEST(Judge, WhatIsNotMatchedIsNeverWrongAndClaimsNothing) {
  MatchResult result = matched_at({3.0, 0.0, 0.0});
  result.status = MatchStatus::kAmbiguous;
  const PairAnswer answer = judge(result, {});
  EXPECT_FALSE(answer.is_success());
  EXPECT_FALSE(answer.is_wrong());
  EXPECT_FALSE(answer.nees.has_value());
}

TEST(Judge, WithoutAPoseThereIsNoSuccess) {
  const PairAnswer answer = judge(MatchResult{}, {});
  EXPECT_TRUE(std::isnan(answer.error_m()));
  EXPECT_FALSE(answer.is_success());
}

TEST(Judge, SingularInformationGivesNoNees) {
  MatchResult result = matched_at({});
  result.information(0, 0) = 0.0;
  EXPECT_FALSE(judge(result, {}).nees.has_value());
}

BuildingPairs building_with(double overlap, bool is_determined, double error_m) {
  BuildingPairs building;
  PairRecord record;
  record.truth.overlap = overlap;
  record.truth.is_determined = is_determined;
  record.ours = judge(matched_at({error_m, 0.0, 0.0}), {});
  building.pairs.push_back(record);
  return building;
}

TEST(BuildingSummary, UndeterminedPairsCountAsWrongButNotAsFailures) {
  BuildingStudy study;
  study.buildings.push_back(building_with(0.9, true, 0.0));
  study.buildings.push_back(building_with(0.9, false, 1.0));
  study.buildings.push_back(building_with(0.4, true, 0.0));
  const BuildingSummary all = summarise(study);
  EXPECT_EQ(all.ours.high.num_pairs, 1U);
  EXPECT_EQ(all.ours.high.num_success, 1U);
  EXPECT_EQ(all.ours.middle.num_pairs, 1U);
  EXPECT_EQ(all.num_high, 2U);
  EXPECT_EQ(all.num_high_undetermined, 1U);
  EXPECT_EQ(all.ours.all.num_wrong, 1U);
  const PairLists lists = list_pairs(study);
  EXPECT_EQ(lists.wrong.size(), 1U);
  EXPECT_EQ(lists.excluded.size(), 1U);
  EXPECT_TRUE(lists.failures.empty());
}

TEST(Tally, AWrongAnswersErrorIsNoMeasureOfTheCovariance) {
  Tally tally;
  tally.add(judge(matched_at({0.1, 0.0, 0.0}), {}));
  tally.add(judge(matched_at({0.0, 0.0, 0.0}), {}));
  tally.add(judge(matched_at({9.0, 0.0, 0.0}), {}));
  EXPECT_EQ(tally.num_wrong, 1U);
  EXPECT_NEAR(tally.right_nees.mean(), 0.5, 1e-9);
  EXPECT_EQ(tally.right_nees_inside_share(), 1.0);
  EXPECT_NEAR(tally.nees_inside_share(), 2.0 / 3.0, 1e-12);
}

TEST(BuildingStudy, TheNumberOfThreadsChangesNothing) {
  BuildingStudyParams params;
  params.num_seeds = 1;
  params.pairs.has_paper = false;
  const std::string alone = json_from(study_buildings(params, 1)).dump();
  EXPECT_EQ(json_from(study_buildings(params, 3)).dump(), alone);
  EXPECT_NE(alone.find("\"num_buildings\":5"), std::string::npos);
}

TEST(RunInParallel, EveryTaskRunsOnceAndTheFirstFailureIsReported) {
  std::vector<int> runs(50, 0);
  std::size_t told = 0;
  run_in_parallel(
      50, 4, [&](std::size_t i) { ++runs[i]; }, [&](std::size_t, std::size_t) { ++told; });
  EXPECT_EQ(runs, std::vector<int>(50, 1));
  EXPECT_EQ(told, 50U);
  const auto fail = [](std::size_t i) {
    if (i == 7 || i == 30) throw std::runtime_error(std::to_string(i));
  };
  try {
    run_in_parallel(50, 4, fail);
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "7");
  }
}

TEST(PaperExperiment, AnUnknownSectionIsRefused) {
  PaperExperimentParams params;
  params.sections = {"section_6"};
  EXPECT_THROW(static_cast<void>(run_paper_experiment(params)), ParameterError);
}

}  // namespace setsquare::experiments::experiment_pairs_test
