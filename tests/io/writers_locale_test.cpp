// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A program may have set its own locale: files stay what they are.
#include <gtest/gtest.h>

#include <array>
#include <locale>
#include <sstream>
#include <string>

#include "setsquare/io/logs/carmen/writer.hpp"
#include "setsquare/io/maps/map_yaml.hpp"
#include "setsquare/io/tables/closures_tsv.hpp"
#include "setsquare/io/tables/pose_graph_g2o.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"

namespace setsquare::writers_locale_test {

/// As in German: a comma before decimals, a point between thousands.
class CommaPoint final : public std::numpunct<char> {
 protected:
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// While it lives, the global C++ locale has commas.
class CommaLocale {
 public:
  CommaLocale() : before_(std::locale::global({std::locale::classic(), new CommaPoint})) {}
  ~CommaLocale() { std::locale::global(before_); }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;

 private:
  std::locale before_;
};

/// The text of every writer, with numbers above a thousand and with decimals.
std::string all_texts() {
  const Pose2 pose = {12345.678, -0.25, 1.5};
  const Timestamp stamp{1234567'250000000};
  std::string log;
  append_carmen_true_pose(log, stamp, pose, pose);
  const Trajectory trajectory = {{stamp, pose}};
  const std::array<LoopClosure, 1> closures = {
      {{stamp, stamp, pose, ClosureAxes::kXY, true, 0.5, "alike"}}};
  PoseGraph graph;
  graph.T_map_node = {pose, pose};
  graph.constraints = {{.from = 0, .to = 1, .T_from_to = pose}};
  const MapYaml yaml = {.image = "a map.pgm", .resolution_m = 0.05, .T_map_grid = pose};
  return log + tum_from_trajectory(trajectory) + tsv_from_closures(closures) +
         g2o_from_pose_graph(graph) + text_from_map_yaml(yaml);
}

TEST(Writers, WriteTheSameUnderAnyGlobalLocale) {
  const std::string before = all_texts();
  const CommaLocale german;
  std::ostringstream number;
  number << 1.5;
  ASSERT_EQ(number.str(), "1,5");  // the locale is in force
  EXPECT_EQ(all_texts(), before);
}

}  // namespace setsquare::writers_locale_test
