// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A program may have set its own locale: files stay what they are.
#include <gtest/gtest.h>

#include <array>
#include <clocale>
#include <cstdlib>
#include <locale>
#include <sstream>
#include <string>

#include "setsquare/io/logs/carmen/writer.hpp"
#include "setsquare/io/logs/csv/writer.hpp"
#include "setsquare/io/logs/json_lines/writer.hpp"
#include "setsquare/io/maps/map_yaml.hpp"
#include "setsquare/io/tables/closures_tsv.hpp"
#include "setsquare/io/tables/pose_graph_g2o.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"
#include "tests/io/read_all.hpp"

namespace setsquare::locale_test {

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

/// What the readers make of those texts and of logs, written again.
std::string all_texts_again(const std::string& texts) {
  const MapYaml yaml = map_yaml_from_text(
      "image: \"a map.pgm\"\nresolution: 0.05\norigin: [-12345.678, 2.5e-1, 1.5]\nnegate: 0\n"
      "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
      "map.yaml");
  std::string again = text_from_map_yaml(yaml);
  for (const char* log : {"FLASER 2 1.25 1234.5 0.5 0 0 0.5 0 0 12345.678901 h 0\n",
                          "stamp,angle_min,angle_step,ranges\n12345.5,-1.5,0.5,1.25,1234.5\n",
                          "{\"stamp\":12345.5,\"angle_min\":-1.5,\"angle_step\":0.5,"
                          "\"sensor\":\"\\u00e4\",\"ranges\":[1.25,1234.5]}\n"}) {
    for (const LogRecord& record : testing::read_all(std::string(log)).records) {
      append_json_record(again, record);
      append_csv_scan(again, record);
      append_carmen_scan(again, record.scan, {});
    }
  }
  const std::string track = "12345.5 1.5 1234.5 0 0 0 0 1\n";
  again += tum_from_trajectory(read_trajectory_tum(make_memory_source(track), "track.tum"));
  const std::size_t table = texts.find("stamp_i");
  const std::string closures = texts.substr(table, texts.find("VERTEX_SE2") - table);
  return again + tsv_from_closures(read_closures_tsv(make_memory_source(closures), "c.tsv"));
}

/// Whether `texts` and what is read back are as under the classic locale.
void expect_unchanged(const std::string& texts, const std::string& again) {
  EXPECT_EQ(all_texts(), texts);
  EXPECT_EQ(all_texts_again(texts), again);
}

TEST(Files, AreTheSameUnderAnyGlobalLocaleOfCpp) {
  const std::string texts = all_texts();
  const std::string again = all_texts_again(texts);
  const CommaLocale german;
  std::ostringstream number;
  number << 1.5;
  ASSERT_EQ(number.str(), "1,5");  // the locale is in force
  expect_unchanged(texts, again);
}

/// While it lives, the C library has decimal commas, where the machine has such a language.
class CommaLanguage {
 public:
  CommaLanguage() {
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8", "sv_SE.UTF-8"}) {
      is_set_ = is_set_ || std::setlocale(LC_ALL, name) != nullptr;
    }
  }
  ~CommaLanguage() { std::setlocale(LC_ALL, "C"); }
  CommaLanguage(const CommaLanguage&) = delete;
  CommaLanguage& operator=(const CommaLanguage&) = delete;
  [[nodiscard]] bool is_set() const { return is_set_; }

 private:
  bool is_set_ = false;
};

TEST(Files, AreTheSameInAnyLanguageOfTheMachine) {
  const std::string texts = all_texts();
  const std::string again = all_texts_again(texts);
  const CommaLanguage german;
  if (!german.is_set()) GTEST_SKIP() << "no language with decimal commas on this machine";
  ASSERT_EQ(std::strtod("1,5", nullptr), 1.5);
  expect_unchanged(texts, again);
}

}  // namespace setsquare::locale_test
