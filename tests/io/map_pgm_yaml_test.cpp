// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/maps/map_pgm_yaml.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "setsquare/core/error.hpp"
#include "tests/io/read_all.hpp"
#include "tests/support/temporary_folder.hpp"

namespace setsquare::map_pgm_yaml_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

PgmImage read(const std::string& bytes) { return read_pgm(make_memory_source(bytes), "map.pgm"); }

std::string error_of_image(const std::string& bytes) {
  try {
    static_cast<void>(read(bytes));
  } catch (const FormatError& error) {
    return error.what();
  }
  return "no error";
}

std::string error_of_yaml(const std::string& text) {
  try {
    static_cast<void>(map_yaml_from_text(text, "map.yaml"));
  } catch (const FormatError& error) {
    return error.what();
  }
  return "no error";
}

const char* const kYaml =
    "image: map.pgm\nresolution: 0.05\norigin: [-1.5, 2, 0.25]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

TEST(PgmImage, BinaryAndPlainFormsHoldTheSame) {
  const std::string binary = std::string("P5\n# made by hand\n3 2\n255\n") +
                             std::string("\x00\x80\xff\x0a\x20\x30", 6) + "what follows";
  const PgmImage image = read(binary);
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.white, 255);
  EXPECT_THAT(image.values, ElementsAre(0, 128, 255, 10, 32, 48));
  EXPECT_EQ(read("P2 3 2 255\n0 128 255 # remark 7\n10 32\r\n48").values, image.values);
  const PgmImage trickled =
      read_pgm(std::make_unique<testing::TricklingSource>(binary, 1), "map.pgm");
  EXPECT_EQ(trickled.values, image.values);
  EXPECT_THAT(read(std::string("P5 2 1 1000 \x01\x02\x03\xe8", 16)).values, ElementsAre(258, 1000));
}

TEST(PgmImage, ErrorsNameTheOffsetAndTheReason) {
  EXPECT_THAT(error_of_image(""), HasSubstr("map.pgm, offset 0: not a PGM"));
  EXPECT_THAT(error_of_image("\x89PNG\r\n"), HasSubstr("not a PGM"));
  EXPECT_THAT(error_of_image("P6 1 1 255 abc"), HasSubstr("not a PGM"));
  EXPECT_THAT(error_of_image("P5 0 1 255 a"), HasSubstr("the width"));
  EXPECT_THAT(error_of_image("P5 1 -1 255 a"), HasSubstr("the height"));
  EXPECT_THAT(error_of_image("P5 1 99999999999999999999 255 a"), HasSubstr("the height"));
  EXPECT_THAT(error_of_image("P5 1 1 70000 ab"), HasSubstr("the maximum value"));
  EXPECT_THAT(error_of_image("P5 2 2 255 abc"), HasSubstr("offset 14: the image ends too early"));
  EXPECT_THAT(error_of_image("P2 2 1 255 7"), HasSubstr("ends too early"));
  EXPECT_THAT(error_of_image("P2 1 1 255 256"), HasSubstr("a pixel"));
  EXPECT_THAT(error_of_image("P2 1 1 255 1x"), HasSubstr("a pixel"));
  EXPECT_THAT(error_of_image("P5 1 1 100 z"), HasSubstr("brighter than white"));
}

TEST(PgmImage, AWrongHeaderAllocatesNothing) {
  EXPECT_THAT(error_of_image("P5 1000000 1000000 255 abc"), HasSubstr("100 million"));
  // 200 MB by the header; the bytes end first.
  EXPECT_THAT(error_of_image("P5 1000000 100 255 abc"), HasSubstr("ends too early"));
}

TEST(PgmImage, AHeaderOfWindowsLines) {
  const std::string pixels("\x0a\x80\xff", 3);
  EXPECT_THAT(read("P5\r\n3 1\r\n255\r\n" + pixels).values, ElementsAre(10, 128, 255));
  // A lone CR is a blank; a pixel of value 10 may follow it.
  EXPECT_THAT(read("P5\n3 1\n255\r" + pixels).values, ElementsAre(10, 128, 255));
}

TEST(MapYaml, ReadsWhatMapServerWrites) {
  const MapYaml map = map_yaml_from_text(std::string(kYaml) + "mode: scale\n", "map.yaml");
  EXPECT_EQ(map.image, "map.pgm");
  EXPECT_EQ(map.resolution_m, 0.05);
  EXPECT_EQ(map.T_map_grid, (Pose2{-1.5, 2.0, 0.25}));
  EXPECT_FALSE(map.is_negated);
  EXPECT_EQ(map.occupied_threshold, 0.65);
  EXPECT_EQ(map.free_threshold, 0.196);
  EXPECT_EQ(map.mode, MapMode::kScale);
  const MapYaml brief = map_yaml_from_text(
      "{image: /a/b.pgm, resolution: 1, origin: [0, 0, 0], negate: true}", "map.yaml");
  EXPECT_TRUE(brief.is_negated);
  EXPECT_EQ(brief.mode, MapMode::kTrinary);
}

TEST(MapYaml, ErrorsNameTheLineAndTheReason) {
  const auto with = [](const std::string& line) {
    return error_of_yaml("image: a.pgm\nresolution: 0.05\n" + line + "\n");
  };
  EXPECT_THAT(error_of_yaml(""), HasSubstr("map.yaml: not the yaml file of a map"));
  EXPECT_THAT(error_of_yaml("just words"), HasSubstr("not the yaml file"));
  EXPECT_THAT(error_of_yaml("a: [1, 2\nb: }"), HasSubstr("map.yaml, line 2: "));
  EXPECT_THAT(error_of_yaml("resolution: 0.05\n"), HasSubstr("image is missing"));
  EXPECT_THAT(with(""), HasSubstr("origin is missing"));
  EXPECT_THAT(with("origin: [1, 2]"), HasSubstr("line 3: origin"));
  EXPECT_THAT(with("origin: [1, 2, .nan]"), HasSubstr("line 3: origin"));
  EXPECT_THAT(with("origin: [1, 2, 0]\nnegate: maybe"), HasSubstr("line 4: negate"));
  EXPECT_THAT(with("origin: [1, 2, 0]\nmode: best"), HasSubstr("line 4: mode"));
  EXPECT_THAT(with("origin: [1, 2, 0]\nfree_thresh: 0.9"), HasSubstr("line 4: free_thresh"));
  EXPECT_THAT(with("origin: [1, 2, 0]\nfree_thresh: low"), HasSubstr("line 4: free_thresh"));
  EXPECT_THAT(error_of_yaml("image: a\nresolution: 0\norigin: [0, 0, 0]"),
              HasSubstr("line 2: resolution"));
  EXPECT_THAT(error_of_yaml("image: a\nresolution: 1e-300\norigin: [0, 0, 0]"),
              HasSubstr("line 2: resolution must be from 0.0001"));
}

TEST(MapPgmYaml, APipeIsNoImage) {
  const testing::TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder.path() / "pipe.pgm").c_str(), 0600), 0);
  static_cast<void>(
      folder.write("map.yaml", "image: pipe.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n"));
  try {
    static_cast<void>(read_map_pgm_yaml((folder.path() / "map.yaml").string()));
    FAIL() << "a pipe was taken";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("pipe.pgm: not a regular file"));
  }
}

PgmImage row_of(const std::vector<std::uint16_t>& values) {
  return {static_cast<std::int32_t>(values.size()), 1, 255, values};
}

std::vector<CellState> states_of(const OccupancyGrid& grid) {
  std::vector<CellState> states;
  for (std::int32_t column = 0; column < grid.num_columns(); ++column) {
    states.push_back(grid.state({column, 0}));
  }
  return states;
}

TEST(MapPgmYaml, GreyBecomesOccupancyAsMapServerSays) {
  MapYaml map = map_yaml_from_text(kYaml, "map.yaml");
  // map_saver's own greys: 0 occupied, 254 free, 205 unknown; then the thresholds' neighbours.
  EXPECT_THAT(states_of(grid_from_pgm_yaml(row_of({0, 254, 205, 89, 90, 206}), map)),
              ElementsAre(CellState::kOccupied,
                          CellState::kFree,
                          CellState::kUnknown,
                          CellState::kOccupied,
                          CellState::kUnknown,
                          CellState::kFree));
  map.is_negated = true;
  EXPECT_THAT(states_of(grid_from_pgm_yaml(row_of({0, 254, 100}), map)),
              ElementsAre(CellState::kFree, CellState::kOccupied, CellState::kUnknown));
  map.is_negated = false;
  map.mode = MapMode::kScale;
  const OccupancyGrid scaled = grid_from_pgm_yaml(row_of({0, 120, 147, 170, 255}), map);
  EXPECT_NEAR(scaled.probability({0, 0}), 0.99, 1e-6);
  EXPECT_NEAR(scaled.probability({1, 0}), (135.0 / 255.0 - 0.196) / 0.454, 1e-6);
  EXPECT_NEAR(scaled.probability({3, 0}), (85.0 / 255.0 - 0.196) / 0.454, 1e-6);
  map.mode = MapMode::kRaw;
  EXPECT_THAT(states_of(grid_from_pgm_yaml(row_of({0, 100, 101, 255, 70}), map)),
              ElementsAre(CellState::kFree,
                          CellState::kOccupied,
                          CellState::kUnknown,
                          CellState::kUnknown,
                          CellState::kOccupied));
}

TEST(MapPgmYaml, TheImageIsInTheFolderOfTheYamlAndBeginsAtItsTop) {
  const testing::TemporaryFolder temporary;
  const std::filesystem::path& folder = temporary.path();
  std::ofstream(folder / "map.yaml") << kYaml;
  std::ofstream(folder / "map.pgm") << "P2 2 2 255 254 0 205 254";
  const OccupancyGrid grid = read_map_pgm_yaml((folder / "map.yaml").string());
  EXPECT_EQ(grid.T_map_grid(), (Pose2{-1.5, 2.0, 0.25}));
  EXPECT_EQ(grid.resolution_m(), 0.05);
  EXPECT_EQ(grid.state({0, 0}), CellState::kUnknown);
  EXPECT_EQ(grid.state({1, 0}), CellState::kFree);
  EXPECT_EQ(grid.state({0, 1}), CellState::kFree);
  EXPECT_EQ(grid.state({1, 1}), CellState::kOccupied);
  std::filesystem::remove(folder / "map.pgm");
  EXPECT_THROW(static_cast<void>(read_map_pgm_yaml((folder / "map.yaml").string())), FileError);
  std::filesystem::remove(folder / "map.yaml");
  EXPECT_THROW(static_cast<void>(read_map_pgm_yaml((folder / "map.yaml").string())), FileError);
}

}  // namespace setsquare::map_pgm_yaml_test
