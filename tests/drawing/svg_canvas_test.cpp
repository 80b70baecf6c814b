// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/drawing/svg_canvas.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "tests/support/xml_fault.hpp"

namespace setsquare::svg_canvas_test {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::xml_fault;

const ShapeStyle kLine = {.fill = {}, .stroke = color(0x1f2933), .dashes = "4 3"};

TEST(XmlFault, FindsWhatIsNotWellFormed) {
  EXPECT_EQ(xml_fault("<a x=\"1\"><b/>t &amp; u</a>\n"), std::nullopt);
  EXPECT_EQ(xml_fault("<?xml version=\"1.0\"?>\n<a></a>"), std::nullopt);
  for (const char* broken : {"",
                             "<a>",
                             "<a></b>",
                             "<a><b></a></b>",
                             "<a x=1/>",
                             "<a x=\"1\" x=\"2\"/>",
                             "<a>b & c</a>",
                             "<a x=\"&bad;\"/>",
                             "<a/><b/>",
                             "<a x=\"1",
                             "<a>\x01</a>"}) {
    EXPECT_NE(xml_fault(broken), std::nullopt) << broken;
  }
}

TEST(SvgCanvas, EveryShapeIsWellFormed) {
  SvgCanvas canvas(640.0, 480.5);
  canvas.begin_clip({10, 10}, {600, 400});
  canvas.rectangle(
      {1, 2}, {3, 4}, {.fill = color(0xff8000), .stroke = {}, .opacity = 0.5, .dashes = {}});
  canvas.circle({5, 6}, 7, kLine);
  canvas.line({0, 0}, {1, 1}, kLine);
  const std::array<Eigen::Vector2d, 3> points = {
      Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 2), Eigen::Vector2d(3, 1)};
  canvas.polyline(points, kLine);
  canvas.dots(points, 1.5, color(0x0000ff), 0.7);
  canvas.end_clip();
  canvas.text({10, 20}, "M(theta) [counts^2]", {.rotation_deg = -90.0});
  EXPECT_EQ(xml_fault(canvas.document()), std::nullopt);
  EXPECT_EQ(xml_fault(canvas.element()), std::nullopt);
  EXPECT_THAT(canvas.document(), ::testing::StartsWith("<?xml"));
  EXPECT_THAT(canvas.element(), HasSubstr("viewBox=\"0 0 640 480.5\""));
  EXPECT_THAT(canvas.element(), HasSubstr("fill=\"#ff8000\""));
  EXPECT_THAT(canvas.element(), HasSubstr("d=\"M0 0L1 2L3 1\""));
  EXPECT_THAT(canvas.element(), HasSubstr("rotate(-90 10 20)"));
}

TEST(SvgCanvas, TextCannotBreakOut) {
  SvgCanvas canvas(10, 10);
  canvas.text({0, 0}, "</text><script>alert('\"&')</script>\x02");
  EXPECT_EQ(xml_fault(canvas.document()), std::nullopt);
  EXPECT_THAT(canvas.document(), Not(HasSubstr("<script>")));
}

TEST(SvgCanvas, GapsBreakALine) {
  SvgCanvas canvas(10, 10);
  const double nan = std::nan("");
  const std::vector<Eigen::Vector2d> points = {{0, 0}, {1, 0}, {nan, 0}, {2, 0}, {3, 0}};
  canvas.polyline(points, kLine);
  EXPECT_THAT(canvas.element(), HasSubstr("M0 0L1 0M2 0L3 0"));
  SvgCanvas empty(10, 10);
  empty.polyline({}, kLine);
  empty.dots({}, 1.0, color(0), 1.0);
  EXPECT_THAT(empty.element(), Not(HasSubstr("<path")));
}

TEST(SvgNumber, IsShortAndAlwaysANumber) {
  EXPECT_EQ(svg_number(0.0), "0");
  EXPECT_EQ(svg_number(-0.001), "0");
  EXPECT_EQ(svg_number(100.0), "100");
  EXPECT_EQ(svg_number(1.5), "1.5");
  EXPECT_EQ(svg_number(-2.349), "-2.35");
  EXPECT_EQ(svg_number(std::nan("")), "0");
  EXPECT_EQ(svg_number(std::numeric_limits<double>::infinity()), "0");
}

}  // namespace setsquare::svg_canvas_test
