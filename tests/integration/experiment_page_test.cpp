// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "experiments/goals.hpp"
#include "experiments/paper_experiment.hpp"
#include "experiments/small_worlds.hpp"
#include "experiments/text_table.hpp"
#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/pairs/pair_geometry.hpp"

namespace setsquare::experiments::experiment_page_test {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(TextTable, HasColumns) {
  const TextTable table{"caption", {"", "n"}, {{"a", "100"}, {"long", "1"}}};
  EXPECT_EQ(text_of(table), "caption\n        n\na     100\nlong    1\n");
}

TEST(TextTable, WhatIsNotKnownIsADash) {
  EXPECT_EQ(percent(std::numeric_limits<double>::quiet_NaN()), "-");
  EXPECT_EQ(number(std::numeric_limits<double>::quiet_NaN(), 2), "-");
  EXPECT_EQ(percent(0.98765, 1), "98.8 %");
}

/// What stands in a script element of the page that holds data.
nlohmann::json data_of(const std::string& page, const std::string& id) {
  const std::string opening = "<script type=\"application/json\" id=\"" + id + "\">";
  const std::size_t start = page.find(opening) + opening.size();
  return nlohmann::json::parse(page.substr(start, page.find("</script>", start) - start));
}

/// One small run of what is quick to make: the page holds the numbers and needs no other file.
TEST(PaperExperiment, ThePageHoldsItsNumbersAndNeedsNoOtherFile) {
  PaperExperimentParams params;
  params.sections = {"honesty", "section_5_1"};
  params.is_quick = true;
  const PaperExperiment experiment = run_paper_experiment(params);
  const auto json = nlohmann::json::parse(paper_json(experiment));
  EXPECT_EQ(json.at("honesty").at("worlds").size(), 7U);
  EXPECT_EQ(json.at("honesty").at("worlds")[0].at("what_can_be_known"), "open along the corridor");
  EXPECT_EQ(json.at("section_5_1").at("pairs_of_the_first").size(), 105U);
  EXPECT_EQ(json.at("section_5_1").at("all_hallways").at("mrpt_icp"), "MRPT is not installed");
  EXPECT_FALSE(json.contains("buildings"));
  EXPECT_EQ(json.at("goals").size(), 9U);
  EXPECT_TRUE(json.at("timing").contains("honesty_s"));

  const std::string page = paper_html(experiment);
  EXPECT_EQ(data_of(page, "numbers"), json);
  const auto hallway = data_of(page, "drawings").at("hallway");
  EXPECT_EQ(hallway.at("paths")[0].at("points").size(), 15U);
  EXPECT_EQ(hallway.at("walls").size(), experiment.hallways->runs[0].plan.segments.size());
  for (const char* other :
       {"@STYLE@", "@SCRIPT@", "@NUMBERS@", "href=\"http", "src=\"", "@import"}) {
    EXPECT_THAT(page, Not(HasSubstr(other)));
  }
  EXPECT_THAT(page, HasSubstr("name=\"viewport\""));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
}

/// A peer's answers get the column that is left out without one.
TEST(PaperExperiment, APeersAnswersAreJudgedLikeOurs) {
  HallwayStudyParams params;
  params.num_seeds = 1;
  params.num_scans = 3;
  const auto zero = [](const Scan&, const Scan&) -> std::optional<Pose2> { return Pose2{}; };
  const auto json = json_from(study_hallways(params, zero, 1));
  const auto& icp = json.at("all_hallways").at("mrpt_icp").at("all_pairs");
  EXPECT_EQ(icp.at("num_pairs"), 3);
  EXPECT_EQ(icp.at("num_matched"), 3);
  EXPECT_LT(icp.at("num_success"), 3) << "the scans are 0.4 m apart";
}

/// The project's goals on the quick run; `--check-goals` checks them on the whole one.
void expect_musts(const std::vector<std::string>& sections, std::size_t num_goals) {
  PaperExperimentParams params;
  params.sections = sections;
  params.is_quick = true;
  std::size_t num_known = 0;
  for (const Goal& goal : goals_of(run_paper_experiment(params))) {
    if (!goal.is_known) continue;
    ++num_known;
    EXPECT_TRUE(goal.meets_must) << goal.what << ": " << goal.reached << ", must: " << goal.must;
  }
  EXPECT_EQ(num_known, num_goals);
}

TEST(PaperExperiment, PairsReachWhatTheyMust) { expect_musts({"section_5_1", "buildings"}, 6); }

TEST(PaperExperiment, TheLargeBuildingReachesWhatItMust) { expect_musts({"section_5_2"}, 3); }

TEST(Goals, WhatWasNotRunIsNotKnown) {
  for (const Goal& goal : goals_of(PaperExperiment{})) {
    EXPECT_FALSE(goal.is_known) << goal.what;
    EXPECT_EQ(goal.reached, "-");
  }
}

TEST(Goals, AWrongAnswerTooManyMissesTheMust) {
  BuildingPairs building;
  PairRecord record;
  record.ours.status = MatchStatus::kMatched;
  record.ours.error = {9.0, 0.0, 0.0};
  building.pairs.push_back(record);
  PaperExperiment experiment;
  experiment.buildings = BuildingStudy{{building}};
  const Goal wrong = goals_of(experiment)[2];
  EXPECT_TRUE(wrong.is_known);
  EXPECT_FALSE(wrong.meets_must);
  EXPECT_EQ(wrong.reached, "1 of 1 (100.000 %)");
}

TEST(SmallWorlds, AreWhatTheyAreCalled) {
  const auto geometry_in = [](SmallWorld world) {
    const Building building = make_small_world(world, 3);
    const RayCaster caster(building.plan);
    const RobotPath path(building.route_m);
    return pair_geometry(caster, utm_30lx(), path.pose_at(0.0), path.pose_at(2.0));
  };
  EXPECT_LT(geometry_in(SmallWorld::kBareCorridor).wall_across_m, 0.01);
  EXPECT_LT(geometry_in(SmallWorld::kRoundHall).wall_turning_m3, 0.3);
  EXPECT_TRUE(geometry_in(SmallWorld::kSymmetricRoom).is_determined());
  EXPECT_TRUE(geometry_in(SmallWorld::kNiches).is_determined());
  EXPECT_FALSE(geometry_in(SmallWorld::kOpenField).is_determined());
}

}  // namespace setsquare::experiments::experiment_page_test
