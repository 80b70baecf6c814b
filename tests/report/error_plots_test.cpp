// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/error_plots.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/support/xml_fault.hpp"

namespace setsquare::error_plots_test {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<Timestamp> stamps_every(double step_s, int num) {
  std::vector<Timestamp> stamps;
  for (int i = 0; i < num; ++i) stamps.push_back(timestamp_from_seconds(1000.0 + step_s * i));
  return stamps;
}

std::string plot_of(const std::vector<Timestamp>& stamps, const std::vector<double>& values) {
  return error_plot_svg({stamps, values, values});
}

TEST(ErrorPlot, IsAWholePictureOfBothErrors) {
  const std::string svg = plot_of(stamps_every(10.0, 5), {0.1, 0.2, 0.0, 0.4, 0.3});
  EXPECT_EQ(testing::xml_fault(svg), std::nullopt);
  EXPECT_THAT(svg, HasSubstr("error [m]"));
  EXPECT_THAT(svg, HasSubstr("error [deg]"));
  EXPECT_THAT(svg, HasSubstr("time [s]"));
  EXPECT_EQ(svg, plot_of(stamps_every(10.0, 5), {0.1, 0.2, 0.0, 0.4, 0.3}));
  EXPECT_NE(svg, plot_of(stamps_every(10.0, 5), {0.1, 0.2, 0.1, 0.4, 0.3}));
}

TEST(ErrorPlot, OneErrorOrNoneOrNoErrorAtAllIsDrawn) {
  for (const std::string& svg : {plot_of({}, {}),
                                 plot_of(stamps_every(1.0, 1), {0.0}),
                                 plot_of(stamps_every(0.0, 3), {0.0, 0.0, 0.0})}) {
    EXPECT_EQ(testing::xml_fault(svg), std::nullopt);
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
  }
}

TEST(TrajectoryPlot, ShowsBothAtOneScale) {
  const Trajectory reference = {{timestamp_from_seconds(0.0), {0.0, 0.0, 0.0}},
                                {timestamp_from_seconds(1.0), {10.0, 0.0, 0.0}}};
  Trajectory aligned = reference;
  aligned.back().pose.y_m = 1.0;
  const std::string svg = trajectory_plot_svg(aligned, reference);
  EXPECT_EQ(testing::xml_fault(svg), std::nullopt);
  EXPECT_THAT(svg, HasSubstr("reference"));
  EXPECT_NE(svg, trajectory_plot_svg(reference, reference));
  EXPECT_EQ(testing::xml_fault(trajectory_plot_svg({aligned.front()}, {reference.front()})),
            std::nullopt);
}

}  // namespace setsquare::error_plots_test
