// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "setsquare/core/error.hpp"
#include "setsquare/io/bytes/byte_source.hpp"
#include "setsquare/io/maps/map_pgm_yaml.hpp"
#include "tests/support/seed.hpp"

namespace setsquare::map_pgm_yaml_writer_test {

/// What a robot's navigation makes of a map: -1 unknown, 0 free, 100 occupied, row by row from the
/// lowest.
struct ServedMap {
  double resolution_m = 0.0;
  double origin_x_m = 0.0;
  double origin_y_m = 0.0;
  double origin_yaw_rad = 0.0;
  int width = 0;
  int height = 0;
  std::vector<int> cells;
};

/// The plain twin of map_server's (ROS 1) and nav2's loaders, from their documentation and their
/// behaviour in trinary mode, without our readers:
/// the image is read row by row from the top; how dark a pixel is, occ = (255 - value) / 255,
/// decides: above occupied_thresh 100, below free_thresh 0, else -1; the last row of the image is
/// the first of the map, and origin is the pose of that row's first corner.
ServedMap serve(const MapFiles& files) {
  std::map<std::string, std::string> entries;
  std::istringstream yaml(files.yaml);
  for (std::string line; std::getline(yaml, line);) {
    const auto colon = line.find(": ");
    entries[line.substr(0, colon)] = line.substr(colon + 2);
  }
  EXPECT_EQ(entries.at("image"), "map.pgm");
  EXPECT_EQ(entries.at("negate"), "0");
  EXPECT_EQ(entries.at("mode"), "trinary");
  const double occupied_thresh = std::stod(entries.at("occupied_thresh"));
  const double free_thresh = std::stod(entries.at("free_thresh"));
  ServedMap map;
  map.resolution_m = std::stod(entries.at("resolution"));
  EXPECT_EQ(std::sscanf(entries.at("origin").c_str(),
                        "[%lf, %lf, %lf]",
                        &map.origin_x_m,
                        &map.origin_y_m,
                        &map.origin_yaw_rad),
            3);
  int white = 0;
  EXPECT_EQ(std::sscanf(files.pgm.c_str(), "P5\n%d %d\n%d", &map.width, &map.height, &white), 3);
  EXPECT_EQ(white, 255);
  const std::size_t header_size = files.pgm.find("\n255\n") + 5;
  const std::string pixels = files.pgm.substr(header_size);
  EXPECT_EQ(pixels.size(), static_cast<std::size_t>(map.width * map.height));
  for (int row = map.height - 1; row >= 0; --row) {
    for (int column = 0; column < map.width; ++column) {
      const auto value =
          static_cast<unsigned char>(pixels[static_cast<std::size_t>(row * map.width + column)]);
      const double occ = (255 - value) / 255.0;
      map.cells.push_back(occ > occupied_thresh ? 100 : occ < free_thresh ? 0 : -1);
    }
  }
  return map;
}

/// An L of walls (3), free space (-3), weak evidence (0.1, -0.4) and unknown cells (0).
OccupancyGrid small_grid() {
  OccupancyGrid grid({-1.25, 2.5, 0.0}, 0.05, 4, 3);
  grid.values() = {3.0F,
                   3.0F,
                   3.0F,
                   0.0F,  // the lowest row
                   3.0F,
                   -3.0F,
                   -3.0F,
                   -0.4F,  //
                   3.0F,
                   -3.0F,
                   0.1F,
                   0.0F};
  return grid;
}

TEST(MapWriter, MapServerLoadsWhatTheGridHolds) {
  const ServedMap map = serve(map_files_from_grid(small_grid()));
  EXPECT_EQ(map.resolution_m, 0.05);
  EXPECT_EQ(map.origin_x_m, -1.25);
  EXPECT_EQ(map.origin_y_m, 2.5);
  EXPECT_EQ(map.origin_yaw_rad, 0.0);
  EXPECT_EQ(map.width, 4);
  EXPECT_EQ(map.height, 3);
  EXPECT_THAT(map.cells, ::testing::ElementsAre(100, 100, 100, -1, 100, 0, 0, -1, 100, 0, -1, -1));
}

TEST(MapWriter, ThresholdsAreThoseOfTheYamlFile) {
  OccupancyGrid grid({}, 0.1, 2000, 1);
  std::mt19937_64 generator = testing::make_generator();
  std::uniform_real_distribution<float> log_odds(-3.0F, 3.0F);
  for (float& value : grid.values()) value = log_odds(generator);
  const ServedMap map = serve(map_files_from_grid(grid));
  for (std::int32_t column = 0; column < 2000; ++column) {
    const double p = grid.probability({column, 0});
    if (std::abs(p - 0.65) < 1e-6 || std::abs(p - 0.196) < 1e-6) continue;
    EXPECT_EQ(map.cells[static_cast<std::size_t>(column)], p > 0.65 ? 100 : p < 0.196 ? 0 : -1);
  }
}

TEST(MapWriter, FilesAreThoseThatMapSaverWrites) {
  OccupancyGrid grid({-12.35, 0.0, 0.0}, 0.05, 3, 1);
  grid.values() = {-3.0F, 0.0F, 3.0F};
  const MapFiles files = map_files_from_grid(grid);
  EXPECT_EQ(files.pgm, std::string("P5\n3 1\n255\n\xfe\xcd\x00", 14));
  EXPECT_EQ(files.yaml,
            "image: map.pgm\nmode: trinary\nresolution: 0.05\norigin: [-12.35, 0, 0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

TEST(MapWriter, OurOwnReaderGivesTheMapBack) {
  const MapFiles files = map_files_from_grid(small_grid(), "a map: #1.pgm");
  const MapYaml map = map_yaml_from_text(files.yaml, "map.yaml");
  EXPECT_EQ(map.image, "a map: #1.pgm");
  const OccupancyGrid grid =
      grid_from_pgm_yaml(read_pgm(make_memory_source(files.pgm), "map.pgm"), map);
  EXPECT_EQ(grid.T_map_grid(), small_grid().T_map_grid());
  EXPECT_EQ(grid.state({0, 0}), CellState::kOccupied);
  EXPECT_EQ(grid.state({3, 0}), CellState::kUnknown);
  EXPECT_EQ(grid.state({1, 1}), CellState::kFree);
  EXPECT_EQ(grid.state({2, 2}), CellState::kUnknown);
}

TEST(MapWriter, ATurnedGridIsRefused) {
  const OccupancyGrid turned({0.0, 0.0, 0.01}, 0.05, 2, 2);
  EXPECT_THROW(static_cast<void>(map_files_from_grid(turned)), ParameterError);
}

TEST(MapYaml, TextGivesEveryEntryBack) {
  const MapYaml map{.image = "/maps/x \"y\"/z.pgm",
                    .resolution_m = 0.1 + 0.2,
                    .T_map_grid = {-1.0 / 3.0, 1e-9, 3.0},
                    .is_negated = true,
                    .occupied_threshold = 0.7,
                    .free_threshold = 0.1,
                    .mode = MapMode::kScale};
  const MapYaml again = map_yaml_from_text(text_from_map_yaml(map), "map.yaml");
  EXPECT_EQ(again.image, map.image);
  EXPECT_EQ(again.resolution_m, map.resolution_m);
  EXPECT_EQ(again.T_map_grid, map.T_map_grid);
  EXPECT_EQ(again.is_negated, map.is_negated);
  EXPECT_EQ(again.occupied_threshold, map.occupied_threshold);
  EXPECT_EQ(again.free_threshold, map.free_threshold);
  EXPECT_EQ(again.mode, map.mode);
  MapYaml bad = map;
  bad.resolution_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(static_cast<void>(text_from_map_yaml(bad)), ParameterError);
  bad = map;
  bad.free_threshold = 0.8;
  EXPECT_THROW(static_cast<void>(text_from_map_yaml(bad)), ParameterError);
  bad = map;
  bad.image = "";
  EXPECT_THROW(static_cast<void>(text_from_map_yaml(bad)), ParameterError);
}

TEST(PgmImage, BytesGiveTheImageBack) {
  for (const auto white : std::initializer_list<std::uint16_t>{1, 255, 256, 65535}) {
    PgmImage image{.width = 3, .height = 2, .white = white, .values = {0, 1, white, 1, 0, white}};
    const PgmImage again = read_pgm(make_memory_source(pgm_from_image(image)), "x.pgm");
    EXPECT_EQ(again.values, image.values);
    EXPECT_EQ(again.white, white);
    EXPECT_EQ(again.width, 3);
    image.values.pop_back();
    EXPECT_THROW(static_cast<void>(pgm_from_image(image)), ParameterError);
  }
  EXPECT_THROW(static_cast<void>(pgm_from_image({.width = 1, .height = 1, .values = {256}})),
               ParameterError);
}

}  // namespace setsquare::map_pgm_yaml_writer_test
