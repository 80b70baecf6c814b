// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/map_outputs.hpp"

#include "setsquare/drawing/png.hpp"
#include "setsquare/io/map_pgm_yaml.hpp"

namespace setsquare::app {

std::vector<std::string> map_output_names() {
  return {"trajectory.tum",
          "map.pgm",
          "map.yaml",
          "map.png",
          "graph.g2o",
          "closures.tsv",
          "report.html",
          "timing.json",
          "run.json"};
}

void add_map_files(OutputSet& outputs, const OccupancyGrid& grid) {
  const MapFiles files = map_files_from_grid(grid, "map.pgm");
  outputs.add("map.pgm", files.pgm);
  outputs.add("map.yaml", files.yaml);
}

void add_map_picture(OutputSet& outputs, const Image& picture) {
  outputs.add("map.png", png_from_image(picture));
}

}  // namespace setsquare::app
