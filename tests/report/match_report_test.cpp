// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "setsquare/report/match/report.hpp"
#include "setsquare/report/match/sections.hpp"
#include "tests/support/rectangular_room.hpp"
#include "tests/support/xml_fault.hpp"

namespace setsquare::match_report_test {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::scan_of_room;
using testing::xml_fault;

Scan room_scan(double x_m) { return scan_of_room({x_m, 2.5, 0.2}, 9.0, 6.0, 360); }

MatchStory told(bool is_paper) {
  const StoryNames names = {
      "<log> & \"co\"_\xe6\x97\xa5.clf", "scan 3, stamp 1.500000", "scan 9, stamp 4.250000"};
  return is_paper ? tell_paper_match(room_scan(3.0), room_scan(3.4), names)
                  : tell_default_match(room_scan(3.0), room_scan(3.4), names);
}

class MatchReport : public ::testing::TestWithParam<bool> {};

TEST_P(MatchReport, SvgIsWellFormedAndHasEverySection) {
  const MatchStory story = told(GetParam());
  const std::string svg = match_report_svg(story);
  EXPECT_EQ(xml_fault(svg), std::nullopt);
  for (const char* words : {"the answer: ",
                            "Answer: x ",
                            "Runner-up: x ",
                            "scan 3, stamp 1.500000",
                            "&lt;log&gt; &amp; &quot;co&quot;_\xe6\x97\xa5.clf"}) {
    EXPECT_THAT(svg, HasSubstr(words));
  }
  const std::vector<const char*> of_paper = {"thinned: ",
                                             "M(theta) / mean",
                                             "theta_D reference",
                                             "off it (theta_D + 30 deg)",
                                             "shift lambda [m]",
                                             "chosen: "};
  const std::vector<const char*> of_surfaces = {"coarse samples",
                                                "returns without a line",
                                                "Correlation of the two histograms",
                                                "rotations proposed",
                                                "dropped by the coarse samples: ",
                                                "m of wall compared",
                                                "What decided: ",
                                                "Marginal sigma",
                                                "Proposed: x ",
                                                "Agreeing wall on different lines"};
  for (const char* words : of_paper) {
    EXPECT_EQ(svg.find(words) != std::string::npos, GetParam()) << words;
  }
  for (const char* words : of_surfaces) {
    EXPECT_EQ(svg.find(words) != std::string::npos, !GetParam()) << words;
  }
  for (const MatchSection& section : match_sections(story)) {
    EXPECT_THAT(svg, HasSubstr(">" + section.title + "<"));
    ASSERT_FALSE(section.figure.empty());
    for (const SvgCanvas& panel : section.figure) EXPECT_GT(panel.height_px(), 0.0);
  }
}

TEST_P(MatchReport, HtmlNeedsNothingElse) {
  const MatchStory story = told(GetParam());
  const std::string html = match_report_html(story);
  EXPECT_EQ(xml_fault(html), std::nullopt);
  EXPECT_THAT(html, Not(HasSubstr("<script")));
  EXPECT_THAT(html, Not(HasSubstr("src=")));
  EXPECT_THAT(html, Not(HasSubstr("href=")));
  EXPECT_THAT(html, Not(HasSubstr("url(")));
  EXPECT_THAT(html, Not(HasSubstr("@import")));
  EXPECT_THAT(html, HasSubstr("<table>"));
  EXPECT_THAT(html, HasSubstr("<meta name=\"viewport\""));
  EXPECT_THAT(html, HasSubstr("the answer: "));
  for (const MatchSection& section : match_sections(story)) {
    EXPECT_THAT(html, HasSubstr("<h2>" + section.title + "</h2>"));
  }
}

TEST_P(MatchReport, SameMatchSameBytes) {
  EXPECT_EQ(match_report_svg(told(GetParam())), match_report_svg(told(GetParam())));
}

TEST_P(MatchReport, MatchWithoutAPoseIsReportedToo) {
  Scan empty = room_scan(3.0);
  empty.ranges_m.assign(empty.num_beams(), 81.83);
  const MatchStory story =
      GetParam() ? tell_paper_match(empty, empty, {}) : tell_default_match(empty, empty, {});
  EXPECT_EQ(xml_fault(match_report_svg(story)), std::nullopt);
  EXPECT_EQ(xml_fault(match_report_html(story)), std::nullopt);
  EXPECT_THAT(match_report_html(story), HasSubstr("too_few_points"));
}

INSTANTIATE_TEST_SUITE_P(Presets, MatchReport, ::testing::Bool(), [](const auto& tested) {
  return tested.param ? "Paper" : "Default";
});

}  // namespace setsquare::match_report_test
