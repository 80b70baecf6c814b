// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// What the page's bytes promise; tests/browser looks at what they draw.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "setsquare/report/map/page.hpp"
#include "setsquare/report/map/page_data.hpp"
#include "setsquare/report/map/page_image.hpp"

namespace setsquare::map_report_test {

using ::testing::HasSubstr;
using ::testing::Not;

std::size_t count_of(const std::string& text, const std::string& piece) {
  std::size_t count = 0;
  for (std::size_t i = text.find(piece); i != std::string::npos; i = text.find(piece, i + 1)) {
    ++count;
  }
  return count;
}

/// A drive along x with a scan of `num_points` every metre; closures between the first and others.
Map drive(int num_poses, int num_closures, int num_points) {
  Map map;
  for (int i = 0; i < num_poses; ++i) {
    MappedScan scan;
    scan.stamp = timestamp_from_seconds(976052857.0 + 0.2 * i);
    scan.T_map_base = scan.T_map_sensor = {0.04 * i, 0.3 * std::sin(0.1 * i), 0.1};
    scan.position_sigma_m = 0.02;
    map.scans.push_back(scan);
    if (i % 25 != 0) continue;
    Scan kept;
    kept.stamp = scan.stamp;
    kept.first_bearing_rad = -0.5 * kPi;
    kept.bearing_step_rad = kPi / std::max(1, num_points);
    kept.max_range_m = 80.0;
    for (int p = 0; p < num_points; ++p) {
      const double bearing_rad = kept.first_bearing_rad + p * kept.bearing_step_rad;
      kept.ranges_m.push_back(2.0 / std::cos(0.9 * bearing_rad));
    }
    map.kept_scans.push_back({static_cast<std::size_t>(i), std::make_shared<Scan>(kept)});
  }
  for (int i = 0; i < num_closures; ++i) {
    MappedClosure row;
    row.scan_j =
        map.kept_scans[1 + static_cast<std::size_t>(i) % (map.kept_scans.size() - 1)].index;
    row.closure.reason = "verified";
    map.closures.push_back(row);
  }
  return map;
}

MapReport report_of(const Map& map) { return {.title = "A drive", .map = map}; }

TEST(MapReport, IsTheSameBytesEveryTime) {
  const OccupancyGrid grid({}, 0.05, 10, 10);
  const Map map = drive(100, 3, 20);
  MapReport report = report_of(map);
  report.grid = &grid;
  EXPECT_EQ(map_report_html(report), map_report_html(report));
}

TEST(MapReport, NeedsNoOtherFile) {
  const std::string html = map_report_html(report_of(drive(100, 3, 20)));
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
  for (const char* piece : {"src=\"",
                            "@import",
                            "url(",
                            "fetch(",
                            "XMLHttpRequest",
                            "http://",
                            "https://",
                            "<link rel=\"stylesheet\""}) {
    EXPECT_THAT(html, Not(HasSubstr(piece)));
  }
  for (const char* mark : {"@TITLE@", "@STYLE@", "@HEADLINE@", "@DATA@", "@SCRIPT@"}) {
    EXPECT_THAT(html, Not(HasSubstr(mark)));
  }
}

TEST(MapReport, TextCannotLeaveItsPlace) {
  Map map = drive(50, 1, 5);
  MapReport report = report_of(map);
  const std::string hostile = "</script><script>alert(1)</script><!-- @SCRIPT@ \" ' & \xff";
  const std::string harmless = map_report_html(report);
  report.title = hostile;
  map.closures.front().closure.reason = hostile;
  report.figures = {{hostile, hostile, hostile, hostile, hostile}};
  const std::string html = map_report_html(report);
  EXPECT_EQ(count_of(html, "<script"), count_of(harmless, "<script"));
  EXPECT_EQ(count_of(html, "</script"), count_of(harmless, "</script"));
  EXPECT_EQ(count_of(html, "<!--"), count_of(harmless, "<!--"));
  EXPECT_EQ(count_of(html, "unpackReport("), count_of(harmless, "unpackReport("));
  EXPECT_THAT(map_report_json(report), Not(HasSubstr("<")));
  EXPECT_THAT(html, Not(HasSubstr("\xff")));
}

TEST(MapReport, ShowsTheTitleAsItIs) {
  const Map map = drive(50, 1, 5);
  MapReport report = report_of(map);
  report.title = "B\xc3\xbcro_\xe6\x97\xa5\xe6\x9c\xac.clf";
  const std::string html = map_report_html(report);
  EXPECT_THAT(html, HasSubstr("<title>" + report.title + "</title>"));
  EXPECT_THAT(map_report_json(report), HasSubstr("B\\u00fcro_\\u65e5\\u672c.clf"));
}

TEST(MapReport, StandsNumbersThatAreNone) {
  Map map = drive(50, 1, 5);
  const double nan = std::nan("");
  map.scans[3].T_map_base = {nan, std::numeric_limits<double>::infinity(), nan};
  map.scans[4].position_sigma_m = nan;
  map.closures.front().closure.weight = nan;
  map.keyframes = {3};
  map.headings = {{.tracked_rad = nan, .measured_rad = nan, .weight = nan}};
  map.frames = {{.offset_rad = nan}};
  const std::string json = map_report_json(report_of(map));
  EXPECT_EQ(count_of(json, "null"), 1U);  // The grid, which is not there.
  EXPECT_THAT(json, HasSubstr("\"frames\":[0.0]"));
}

TEST(MapReport, HoldsOnlyTheScansThatClosuresShowAndEachOnce) {
  const std::size_t none = map_report_json(report_of(drive(2500, 0, 180))).size();
  const std::size_t one = map_report_json(report_of(drive(2500, 1, 180))).size();
  const std::size_t many_of_all = map_report_json(report_of(drive(2500, 990, 180))).size();
  const std::size_t scan = one - none;
  EXPECT_GT(scan, 2U * 180);                 // Two scans of 180 points.
  EXPECT_LT(many_of_all - none, 60 * scan);  // 100 scans, ten closures each.
}

TEST(MapReport, TheTrackIsNotDrawnOverScansThatAreLeftOutNorToAnotherSession) {
  Map map = drive(100, 0, 20);
  EXPECT_THAT(map_report_html(report_of(map)), HasSubstr("\"begins\":[]"));
  map.sessions = {{.first_scan = 0, .num_scans = 60, .search = {}},
                  {.first_scan = 60, .num_scans = 40, .recency = 1, .search = {}}};
  map.forgotten_poses = {{.next_scan = 20, .num_scans = 300, .way_m = 12.0}};
  EXPECT_THAT(map_report_html(report_of(map)), HasSubstr("\"begins\":[20,60]"));
}

TEST(MapReport, IsSmallForAnHourOfDriving) {
  // 15,000 poses, 5,000 closures, 600 scans of 180 points: 54 bytes per pose and closure in doubles
  // alone would be 1.1 MB, the points 1.7 MB.
  EXPECT_LT(map_report_html(report_of(drive(15000, 5000, 180))).size(), 850'000U);
}

TEST(MapReportImage, ShowsOccupiedUnknownAndFree) {
  OccupancyGrid grid({1.0, 2.0, 0.3}, 0.5, 6, 5);
  grid.values()[grid.index({2, 1})] = 3.0F;
  grid.values()[grid.index({4, 3})] = -3.0F;
  const auto map = map_report_image(grid);
  ASSERT_TRUE(map);
  ASSERT_EQ(map->image.width_px(), 3);
  ASSERT_EQ(map->image.height_px(), 3);
  EXPECT_EQ(map->image.at(0, 2).red, 0);
  EXPECT_EQ(map->image.at(2, 0).red, 255);
  EXPECT_EQ(map->image.at(1, 1).red, 128);
  EXPECT_EQ(map->pixel_m, 0.5);
  EXPECT_EQ(map->left_m, 1.0);
  EXPECT_EQ(map->bottom_m, 0.5);
}

TEST(MapReportImage, JoinsCellsWhereThereAreTooMany) {
  OccupancyGrid grid({}, 0.1, 101, 40);
  for (float& value : grid.values()) value = -1.0F;
  grid.values()[grid.index({55, 20})] = 2.0F;
  const auto map = map_report_image(grid, 50);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->image.width_px(), 34);
  EXPECT_NEAR(map->pixel_m, 0.3, 1e-12);
  // Cell (55, 20) lies in the block of rows 18 to 20, the seventh of 14 from below.
  EXPECT_EQ(map->image.at(18, 14 - 1 - 6).red, 0);
}

TEST(MapReportImage, IsNothingWhereNothingIsKnown) {
  EXPECT_FALSE(map_report_image(OccupancyGrid({}, 0.1, 5, 5)));
}

}  // namespace setsquare::map_report_test
