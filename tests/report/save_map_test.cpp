// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/save_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>

#include "setsquare/core/error.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/walled_world.hpp"

namespace setsquare::save_map_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// A short way through a room, with a graph where asked for.
Map map_of_room(bool has_graph) {
  Map map;
  for (std::size_t i = 0; i < 8; ++i) {
    MappedScan scan;
    scan.stamp = Timestamp{static_cast<std::int64_t>(i)};
    scan.T_map_base = scan.T_map_sensor = {3.0 + 0.2 * static_cast<double>(i), 3.0, 0.0};
    map.scans.push_back(scan);
    const testing::Fan all_around = {360, -kPi, kTwoPi / 360};
    map.kept_scans.push_back({i,
                              std::make_shared<Scan>(testing::scan_of_walls(
                                  testing::l_shaped_room(), scan.T_map_sensor, all_around))});
    if (has_graph) map.graph.T_map_node.push_back(scan.T_map_base);
  }
  map.pieces = {{0, 8, true}};
  if (has_graph) map.frames = {{}};
  return map;
}

TEST(SaveMap, WritesEveryFileAndNothingElse) {
  const testing::TemporaryFolder folder;
  const std::string out = (folder.path() / "new/deeper").string();
  const std::vector<std::string> names = save_map(map_of_room(true), out, {.title = "A room"});
  EXPECT_THAT(names,
              ElementsAre("map.pgm",
                          "map.yaml",
                          "map.png",
                          "trajectory.tum",
                          "poses.tsv",
                          "graph.g2o",
                          "closures.tsv",
                          "report.html",
                          "map.setsquare",
                          "run.json"));
  std::size_t num_files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(out)) {
    EXPECT_GT(entry.file_size(), 0U) << entry.path();
    ++num_files;
  }
  EXPECT_EQ(num_files, names.size());
  EXPECT_THAT(testing::content_of(out + "/report.html"), HasSubstr("A room"));
  EXPECT_THAT(testing::content_of(out + "/run.json"), HasSubstr("\"scans\": 8"));
}

TEST(SaveMap, WithoutAGraphThereAreNoClosuresAndNoPage) {
  const testing::TemporaryFolder folder;
  const std::vector<std::string> names =
      save_map(map_of_room(false), (folder.path() / "out").string());
  EXPECT_THAT(names, Not(Contains("graph.g2o")));
  EXPECT_THAT(names, Not(Contains("report.html")));
  EXPECT_THAT(names, Contains("map.png"));
}

TEST(SaveMap, NothingOfAnOlderMapStays) {
  const testing::TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  save_map(map_of_room(true), out);
  std::ofstream(out + "/timing.json") << "{}";
  std::ofstream(out + "/notes.txt") << "mine";
  save_map(map_of_room(false), out);
  for (const char* name : {"/graph.g2o", "/closures.tsv", "/report.html", "/timing.json"}) {
    EXPECT_FALSE(std::filesystem::exists(out + name)) << name;
  }
  EXPECT_EQ(testing::content_of(out + "/notes.txt"), "mine");
}

/// The same way, the last of its scans so many pieces that could not be joined, of two scans each.
Map map_with_lost_pieces(std::size_t num_lost) {
  Map map = map_of_room(true);
  const std::size_t num_joined = map.scans.size() - 2 * num_lost;
  map.pieces = {{0, num_joined, true}};
  for (std::size_t i = num_joined; i < map.scans.size(); ++i) {
    map.scans[i].is_placed = false;
    if ((i - num_joined) % 2 == 0) map.pieces.push_back({i, 2, false});
  }
  return map;
}

std::size_t num_lines(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

TEST(SaveMap, EachPieceThatIsNotJoinedHasItsOwnFile) {
  const testing::TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const std::vector<std::string> names = save_map(map_with_lost_pieces(2), out);
  EXPECT_THAT(names, Contains("pieces/2.tum"));
  EXPECT_THAT(names, Contains("pieces/3.tum"));
  EXPECT_THAT(names, Not(Contains("pieces/1.tum"))) << "it is joined";
  EXPECT_EQ(num_lines(testing::content_of(out + "/trajectory.tum")), 4U);
  EXPECT_EQ(num_lines(testing::content_of(out + "/pieces/2.tum")), 2U);
  EXPECT_EQ(num_lines(testing::content_of(out + "/pieces/3.tum")), 2U);
  EXPECT_EQ(num_lines(testing::content_of(out + "/poses.tsv")), 9U) << "all, and the header";
  // The numbers are those of poses.tsv.
  EXPECT_THAT(testing::content_of(out + "/poses.tsv"), HasSubstr("\t3\t0\tnot_joined\n"));
}

TEST(SaveMap, PiecesOfAnOlderMapGoAndOthersFilesThereStay) {
  const testing::TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  save_map(map_with_lost_pieces(3), out);
  for (const char* name : {"mine.tum", "2.txt", "2b.tum", ".tum"}) {
    std::ofstream(out + "/pieces/" + name) << "mine";
  }
  save_map(map_with_lost_pieces(1), out);
  EXPECT_EQ(num_lines(testing::content_of(out + "/pieces/2.tum")), 2U);
  EXPECT_FALSE(std::filesystem::exists(out + "/pieces/3.tum"));
  EXPECT_FALSE(std::filesystem::exists(out + "/pieces/4.tum"));
  save_map(map_of_room(true), out);
  EXPECT_FALSE(std::filesystem::exists(out + "/pieces/2.tum"));
  for (const char* name : {"mine.tum", "2.txt", "2b.tum", ".tum"}) {
    EXPECT_EQ(testing::content_of(out + "/pieces/" + name), "mine") << name;
    std::filesystem::remove(out + "/pieces/" + name);
  }
  save_map(map_of_room(true), out);
  EXPECT_FALSE(std::filesystem::exists(out + "/pieces")) << "it is empty";
}

TEST(SaveMap, AFileNamedPiecesStaysOrIsAnError) {
  const testing::TemporaryFolder folder;
  const std::string out = folder.path().string();
  std::ofstream(out + "/pieces") << "mine";
  save_map(map_of_room(true), out);
  EXPECT_EQ(testing::content_of(out + "/pieces"), "mine");
  EXPECT_THROW(save_map(map_with_lost_pieces(1), out), FileError);
  EXPECT_EQ(testing::content_of(out + "/pieces"), "mine");
}

TEST(SaveMap, SameMapSameBytesByAnyNumberOfThreads) {
  std::map<std::string, std::string> first;
  const Map room = map_of_room(true);
  const auto keep = [&](const std::string& name, std::string_view bytes) { first[name] = bytes; };
  make_map_files(room, {}, keep);
  make_map_files(room, {.num_threads = 3}, [&](const std::string& name, std::string_view bytes) {
    EXPECT_EQ(first.at(name), bytes) << name;
  });
}

TEST(SaveMap, AMapThatIsLoadedGivesTheSameFilesAgain) {
  const SaveMapOptions options = {
      .title = "A room",
      .pose_of = PoseOf::kSensor,
      .run = {.version = "0.0.7", .log = "room.clf", .findings_json = "[1]"}};
  for (const Map& map : {map_of_room(true), map_of_room(false), map_with_lost_pieces(2)}) {
    std::map<std::string, std::string> first;
    make_map_files(map, options, [&](const std::string& name, std::string_view bytes) {
      first[name] = bytes;
    });
    const SavedMap saved = map_from_bytes(first.at("map.setsquare"), "");
    std::map<std::string, std::string> second;
    make_map_files(saved.map,
                   save_options_of(saved.record),
                   [&](const std::string& name, std::string_view bytes) { second[name] = bytes; });
    EXPECT_EQ(first, second);
    EXPECT_THAT(second.at("run.json"), HasSubstr("\"version\": \"0.0.7\""));
  }
}

TEST(SaveMap, AFileInTheFoldersPlaceIsAnError) {
  const testing::TemporaryFolder folder;
  std::ofstream(folder.path() / "taken") << "mine";
  EXPECT_THROW(save_map(map_of_room(true), (folder.path() / "taken").string()), FileError);
  EXPECT_EQ(testing::content_of((folder.path() / "taken").string()), "mine");
}

TEST(RunJson, RefusesOptionsThatAreNoObject) {
  EXPECT_THROW((void)run_json({}, {.options_json = "[1]"}, PoseOf::kBase), ParameterError);
  EXPECT_THROW((void)run_json({}, {.parameters_json = "{"}, PoseOf::kBase), ParameterError);
}

TEST(RunJson, KeepsTextsOfTheUserAsTheyAre) {
  const std::string json = run_json(
      {}, {.log = "B\xc3\xbcro.clf", .options_json = "{\"odometry\":false}"}, PoseOf::kBase);
  EXPECT_THAT(json, HasSubstr("B\xc3\xbcro.clf"));
  EXPECT_THAT(json, HasSubstr("\"odometry\": false"));
}

}  // namespace setsquare::save_map_test
