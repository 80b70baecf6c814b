// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "experiments/chart.hpp"
#include "experiments/page_elements.hpp"
#include "experiments/paper_experiment.hpp"
#include "experiments/small_worlds.hpp"
#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/pairs/pair_geometry.hpp"
#include "tests/support/xml_fault.hpp"

namespace setsquare::experiments {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(PageElements, BytesOfAPngBecomeBase64) {
  EXPECT_THAT(png_element("Man", "m"), HasSubstr("base64,TWFu\""));
  EXPECT_THAT(png_element("Ma", "m"), HasSubstr("base64,TWE=\""));
  EXPECT_THAT(png_element("M", "m"), HasSubstr("base64,TQ==\""));
  EXPECT_THAT(png_element("\xff\xfe\xfd", "m"), HasSubstr("base64,//79\""));
}

TEST(PageElements, WordsAreEscaped) {
  const Table table{"a < b", {"x"}, {{{"<1 & 2>", "good"}}}};
  EXPECT_THAT(table_html(table), HasSubstr("&lt;1 &amp; 2&gt;"));
  EXPECT_THAT(table_html(table), Not(HasSubstr("<1")));
}

TEST(PageElements, ATableForATerminalHasColumns) {
  const Table table{"caption", {"", "n"}, {{{"a"}, {"100", "bad"}}, {{"long"}, {"1"}}}};
  EXPECT_EQ(table_text(table), "caption\n        n\na     100\nlong    1\n");
}

TEST(PageElements, WhatIsNotKnownIsADash) {
  EXPECT_EQ(percent(std::numeric_limits<double>::quiet_NaN()), "-");
  EXPECT_EQ(number(std::numeric_limits<double>::quiet_NaN(), 2), "-");
  EXPECT_EQ(percent(0.98765, 1), "98.8 %");
}

TEST(Chart, PointsThatAreNoNumbersBreakTheCurve) {
  Chart chart;
  chart.series = {{"s", {{0.0, 0.5}, {0.5, std::numeric_limits<double>::quiet_NaN()}, {1.0, 0.5}}}};
  const std::string svg = chart_svg(chart);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_EQ(svg.find('L', svg.find("class=\"curve")), svg.find('L', svg.find("</svg>")));
}

/// One small run of all that is quick to make: the page stands alone and is well-formed.
TEST(PaperExperiment, ThePageIsWellFormedAndNeedsNoOtherFile) {
  PaperExperimentParams params;
  params.sections = {"honesty"};
  params.is_quick = true;
  const PaperExperiment experiment = run_paper_experiment(params);
  const std::string page = paper_html(experiment);
  EXPECT_EQ(testing::xml_fault(page), std::nullopt);
  EXPECT_THAT(page, Not(HasSubstr("href=\"http")));
  EXPECT_THAT(page, Not(HasSubstr("src=\"http")));
  const auto json = nlohmann::json::parse(paper_json(experiment));
  EXPECT_EQ(json.at("honesty").at("worlds").size(), 7U);
  EXPECT_FALSE(json.contains("buildings"));
  EXPECT_EQ(json.at("goals").size(), 9U);
  EXPECT_TRUE(json.at("timing").contains("honesty_s"));
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

}  // namespace
}  // namespace setsquare::experiments
