// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/sim/svg/floor_plan_svg.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "setsquare/core/error.hpp"

namespace setsquare::floor_plan_svg_test {

using ::testing::HasSubstr;

std::string svg(const std::string& content) {
  return "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\">\n" + content +
         "\n</svg>\n";
}

std::vector<PlanSegment> segments_of(const std::string& content, const SvgPlanParams& params = {}) {
  return floor_plan_from_svg(svg(content), "plan.svg", params).plan.segments;
}

std::string error_of(const std::string& text) {
  try {
    static_cast<void>(floor_plan_from_svg(text, "plan.svg"));
  } catch (const FormatError& error) {
    return error.what();
  }
  return "no error";
}

/// "x,y x,y ..." of the ends of consecutive segments, rounded to the millimetre.
std::string chain(const std::vector<PlanSegment>& segments) {
  std::string words;
  const auto add = [&words](const Eigen::Vector2d& p) {
    char text[80];
    std::snprintf(text,
                  sizeof text,
                  "%g,%g ",
                  std::round(1e3 * p.x()) / 1e3 + 0.0,
                  std::round(1e3 * p.y()) / 1e3 + 0.0);
    words += text;
  };
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (i == 0 || (segments[i].start_m - segments[i - 1].end_m).norm() > 1e-9) {
      if (i > 0) words += "| ";
      add(segments[i].start_m);
    }
    add(segments[i].end_m);
  }
  return words;
}

TEST(FloorPlanSvg, EveryStraightShapeWithYTurnedUp) {
  EXPECT_EQ(chain(segments_of("<line x1='1' y1='2' x2='3' y2='4px'/>")), "1,-2 3,-4 ");
  EXPECT_EQ(chain(segments_of("<polyline points='0,0 1,0 1,1'/>")), "0,0 1,0 1,-1 ");
  EXPECT_EQ(chain(segments_of("<polygon points='0 0 1 0 1 1'/>")), "0,0 1,0 1,-1 0,0 ");
  EXPECT_EQ(chain(segments_of("<rect x='1' y='2' width='3' height='4'/>")),
            "4,-6 1,-6 1,-2 4,-2 4,-6 ");
}

TEST(FloorPlanSvg, PathsInTheirManyForms) {
  const auto path = [](const std::string& d) {
    return chain(segments_of("<path d='" + d + "'/>"));
  };
  EXPECT_EQ(path("M0,0 L2,0 L2,1 Z"), "0,0 2,0 2,-1 0,0 ");
  EXPECT_EQ(path("m1 1 2 0 0 2z"), "1,-1 3,-1 3,-3 1,-1 ") << "pairs after m are lines";
  EXPECT_EQ(path("M0 0H2V3h-1v-1"), "0,0 2,0 2,-3 1,-3 1,-2 ");
  EXPECT_EQ(path("M0 0 1 0 1 1Zl0 2"), "0,0 1,0 1,-1 0,0 0,-2 ") << "after Z at the stroke's start";
  EXPECT_EQ(path("M.5.5-1-1e0"), "0.5,-0.5 -1,1 ") << "numbers may touch";
  EXPECT_EQ(path("M0 0L1 0M2 0L3 0"), "0,0 1,0 | 2,0 3,0 ");
}

TEST(FloorPlanSvg, CurvesLieWithinTheToleranceAndEndWhereTheyShould) {
  const auto check = [](const std::string& content, double radius_m, double x_m, double y_m) {
    const auto segments = segments_of(content, {1.0, 0.002});
    ASSERT_GT(segments.size(), 10U) << content;
    for (const PlanSegment& segment : segments) {
      const Eigen::Vector2d center_m(x_m, y_m);
      const Eigen::Vector2d middle_m = 0.5 * (segment.start_m + segment.end_m);
      EXPECT_NEAR((segment.start_m - center_m).norm(), radius_m, 3e-4 * radius_m) << content;
      EXPECT_GT((middle_m - center_m).norm(), radius_m - 0.002 - 3e-4 * radius_m) << content;
    }
  };
  check("<circle cx='1' cy='2' r='3'/>", 3.0, 1.0, -2.0);
  check("<ellipse cx='1' cy='1' rx='1' ry='3' transform='scale(3 1)'/>", 3.0, 3.0, -1.0);
  check("<path d='M4 0A4 4 0 0 1 0 4'/>", 4.0, 0.0, 0.0);
  check("<path d='M4 0A4 4 0 1 0 0 4'/>", 4.0, 0.0, 0.0);
  check("<path d='M4 0A4 4 0 1 1 0 4'/>", 4.0, 4.0, -4.0);
  check("<path d='M4 0a4 4 30 004 4'/>", 4.0, 8.0, 0.0);
  check("<path d='M1 0A.1.1 0 0 1-1 0'/>", 1.0, 0.0, 0.0);
  // A quarter circle as one Bezier curve, and its mirrored continuation.
  check("<path d='M4 0C4 2.2091 2.2091 4 0 4S-4 2.2091-4 0'/>", 4.0, 0.0, 0.0);
  const auto parabola = segments_of("<path d='M0 0Q1 2 2 0T4 0'/>");
  EXPECT_EQ(parabola.back().end_m, Eigen::Vector2d(4.0, 0.0));
  for (const PlanSegment& segment : parabola) {
    const double x_m = segment.start_m.x();
    const double up_m = x_m <= 2.0 ? -x_m * (2.0 - x_m) : (x_m - 2.0) * (4.0 - x_m);
    EXPECT_NEAR(segment.start_m.y(), up_m, 1e-9);
  }
}

TEST(FloorPlanSvg, ARoundedRectangleKeepsItsSides) {
  const auto segments = segments_of("<rect width='4' height='2' rx='0.5'/>");
  double longest_m = 0.0;
  double lowest_m = 0.0;
  for (const PlanSegment& segment : segments) {
    longest_m = std::max(longest_m, (segment.end_m - segment.start_m).norm());
    lowest_m = std::min(lowest_m, segment.start_m.y());
    const bool is_in_corner = std::abs(segment.start_m.x() - 2.0) > 1.51 + 1e-9 &&
                              std::abs(segment.start_m.y() + 1.0) > 0.51 + 1e-9;
    if (!is_in_corner) continue;
    const Eigen::Vector2d center_m(segment.start_m.x() > 2.0 ? 3.5 : 0.5,
                                   segment.start_m.y() > -1.0 ? -0.5 : -1.5);
    EXPECT_NEAR((segment.start_m - center_m).norm(), 0.5, 1e-9);
  }
  EXPECT_NEAR(longest_m, 3.0, 1e-9);
  EXPECT_NEAR(lowest_m, -2.0, 1e-9);
}

TEST(FloorPlanSvg, TransformsOfGroupsAndShapesMultiply) {
  const std::string line = "<line x1='0' y1='0' x2='1' y2='0' transform='translate(1)'/>";
  EXPECT_EQ(chain(segments_of("<g transform='rotate(90)'>" + line + "</g>")), "0,-1 0,-2 ");
  EXPECT_EQ(chain(segments_of("<g transform='scale(2,3) translate(0 1)'>" + line + "</g>")),
            "2,-3 4,-3 ");
  EXPECT_EQ(chain(segments_of("<g transform='matrix(1 0 0 -1 0 5)'>" + line + "</g>")),
            "1,-5 2,-5 ");
  EXPECT_EQ(chain(segments_of("<g transform='rotate(180 1 1)'>" + line + "</g>")), "1,-2 0,-2 ");
  EXPECT_EQ(chain(segments_of(line, {0.01, 0.005})), "0.01,0 0.02,0 ");
}

TEST(FloorPlanSvg, MaterialsComeFromTheShapeOrTheGroupAroundIt) {
  const std::string line = " x1='0' y1='0' x2='1' y2='0'/>";
  const auto segments = segments_of(
      "<line" + line + "<g class='thick glass'><line" + line + "<line class='door'" + line +
      "<line class='red' data-material='pillar'" + line + "</g><g data-material='furniture'><line" +
      line + "<line class='clutter'" + line + "</g>");
  ASSERT_EQ(segments.size(), 6U);
  const std::vector<Material> expected = {Material::kWall,
                                          Material::kGlass,
                                          Material::kDoor,
                                          Material::kPillar,
                                          Material::kFurniture,
                                          Material::kClutter};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(segments[i].material, expected[i]) << i;
}

TEST(FloorPlanSvg, TheRouteIsNoWall) {
  const SvgPlan plan =
      floor_plan_from_svg(svg("<rect width='5' height='5'/><g transform='translate(1 1)'>"
                              "<polyline id='route' points='0,0 2,0 2,2'/></g>"),
                          "plan.svg");
  EXPECT_EQ(plan.plan.segments.size(), 4U);
  ASSERT_EQ(plan.route_m.size(), 3U);
  EXPECT_EQ(plan.route_m[2], Eigen::Vector2d(3.0, -3.0));
  EXPECT_TRUE(floor_plan_from_svg(svg("<rect width='1' height='1'/>"), "x").route_m.empty());
}

TEST(FloorPlanSvg, WhatIsNotDrawnIsNoWall) {
  const std::string wall = "<line x1='0' y1='0' x2='1' y2='0'/>";
  EXPECT_EQ(segments_of(wall + "<defs>" + wall + "</defs><g style='display: none'>" + wall +
                        "</g><g display='none'>" + wall + "</g><text>hello</text><!-- " + wall +
                        " --><line x1='2' x2='2'/>")
                .size(),
            1U);
}

TEST(FloorPlanSvg, ErrorsNameTheLineAndTheReason) {
  EXPECT_THAT(error_of(""), HasSubstr("plan.svg"));
  EXPECT_THAT(error_of("<svg>\n<g>\n</svg>"), HasSubstr("plan.svg, line 3: "));
  EXPECT_THAT(error_of("<html/>"), HasSubstr("not an SVG document"));
  EXPECT_THAT(error_of(svg("")), HasSubstr("not one line"));
  const auto error_in_third = [](const std::string& element) {
    const std::string error = error_of(svg(element));
    EXPECT_THAT(error, HasSubstr("plan.svg, line 3: ")) << element;
    return error;
  };
  EXPECT_THAT(error_in_third("<path d='L1 1'/>"), HasSubstr("begins with M"));
  EXPECT_THAT(error_in_third("<path d='M1 1 X'/>"), HasSubstr("'X'"));
  EXPECT_THAT(error_in_third("<path d='M1'/>"), HasSubstr("missing"));
  EXPECT_THAT(error_in_third("<path d='M0 0A1 1 0 2 0 1 1'/>"), HasSubstr("flag"));
  EXPECT_THAT(error_in_third("<line x2='50%'/>"), HasSubstr("50%"));
  EXPECT_THAT(error_in_third("<line x2='3mm'/>"), HasSubstr("3mm"));
  EXPECT_THAT(error_in_third("<line x2='inf'/>"), HasSubstr("inf"));
  EXPECT_THAT(error_in_third("<line x2='1e300'/>"), HasSubstr("beyond 10 km"));
  EXPECT_THAT(error_in_third("<circle r='-1'/>"), HasSubstr("negative"));
  EXPECT_THAT(error_in_third("<g transform='turn(3)'/>"), HasSubstr("turn"));
  EXPECT_THAT(error_in_third("<g transform='scale(3'/>"), HasSubstr("ends too early"));
  EXPECT_THAT(error_in_third("<use href='#x'/>"), HasSubstr("use"));
  EXPECT_THAT(error_in_third("<g data-material='iron'/>"), HasSubstr("data-material"));
  EXPECT_THAT(error_in_third("<path id='route' d='M0 0L1 1M2 2L3 3'/>"), HasSubstr("route"));
  EXPECT_THROW(static_cast<void>(segments_of("<circle r='1'/>", {0.0, 0.01})), ParameterError);
}

TEST(FloorPlanSvg, ADocumentNestedWithoutEndIsRefused) {
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<g>";
  for (int i = 0; i < 100'000; ++i) deep += "</g>";
  EXPECT_THAT(error_of(svg(deep)), HasSubstr("nested too deeply"));
}

TEST(FloorPlanSvg, AFewBytesCannotAskForAllMemory) {
  std::string curves = "M0 0";
  for (int i = 0; i < 50'000; ++i)
    curves += i % 2 == 0 ? "T9e8 0" : "T0 9e8";  // thousands of chords each
  EXPECT_THAT(error_of(svg("<path d='" + curves + "'/>")), HasSubstr("2 million corners"));
}

TEST(FloorPlanSvg, ACutDocumentIsNeverACrash) {
  const std::string whole =
      svg("<g transform='rotate(5 1 1)'><path d='M4 0a4 4 30 0 0 4 4C1 2 3 4 5 6zH3'/>"
          "<rect width='4' height='2' rx='0.5' class='door'/></g>");
  for (std::size_t size = 0; size < whole.size() - 1; ++size) {
    EXPECT_NE(error_of(whole.substr(0, size)), "no error") << size;
  }
}

}  // namespace setsquare::floor_plan_svg_test
