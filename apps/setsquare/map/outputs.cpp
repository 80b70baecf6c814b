// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/map/outputs.hpp"

#include "apps/setsquare/map/report.hpp"
#include "apps/setsquare/scans/log_options.hpp"
#include "setsquare/drawing/png.hpp"
#include "setsquare/io/maps/map_pgm_yaml.hpp"
#include "setsquare/io/tables/closures_tsv.hpp"
#include "setsquare/io/tables/pose_graph_g2o.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"
#include "setsquare/report/map/building_heading.hpp"
#include "setsquare/report/map/page.hpp"
#include "setsquare/report/map/picture.hpp"

namespace setsquare::app {
namespace {

/// Along the building's walls, where the map's axes are others (the paper's preset).
OccupancyGrid upright_grid(const Map& map, int num_threads) {
  return occupancy_grid(map, num_threads, building_heading_rad(placed_scans(map)));
}

}  // namespace

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

void write_map_outputs(OutputSet& outputs,
                       const MapOptions& options,
                       const MapRun& run,
                       StageClock& clock) {
  const auto num_threads = static_cast<int>(options.num_threads);
  clock.begin("grid");
  const OccupancyGrid grid = occupancy_grid(run.map, num_threads);
  add_map_files(outputs, grid);
  clock.begin("picture");
  const bool is_upright = options.preset == Preset::kDefault;
  const std::vector<LoopClosure> closures = closures_of(run.map);
  const MapPictureLayers layers{.scans = run.map.scans, .closures = closures};
  outputs.add("map.png",
              png_from_image(layered_map_picture(
                  is_upright ? grid : upright_grid(run.map, num_threads), layers)));
  clock.begin("tables");
  outputs.add("trajectory.tum",
              tum_from_trajectory(
                  trajectory_of(run.map, options.is_of_sensor ? PoseOf::kSensor : PoseOf::kBase)));
  if (!run.map.graph.T_map_node.empty()) {
    outputs.add("graph.g2o", g2o_from_pose_graph(run.map.graph));
    outputs.add("closures.tsv", tsv_from_closures(closures));
    clock.begin("report");
    outputs.add("report.html",
                map_report_html({.title = title_of_log(options.log_path),
                                 .map = run.map,
                                 .grid = &grid,
                                 .figures = map_figures(run.map)}));
  }
  outputs.add("run.json", run_json(options, run));
  clock.end();
  outputs.add("timing.json",
              timing_json({.stages = clock.stages(),
                           .num_scans = run.map.scans.size(),
                           .num_threads = num_threads}));
  outputs.commit();
}

}  // namespace setsquare::app
