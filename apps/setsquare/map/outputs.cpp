// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/map/outputs.hpp"

#include "apps/setsquare/map/image.hpp"
#include "apps/setsquare/map/page.hpp"
#include "apps/setsquare/map/report.hpp"
#include "setsquare/drawing/png.hpp"
#include "setsquare/io/maps/map_pgm_yaml.hpp"
#include "setsquare/io/tables/closures_tsv.hpp"
#include "setsquare/io/tables/pose_graph_g2o.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"

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

void write_map_outputs(OutputSet& outputs,
                       const MapOptions& options,
                       const MapRun& run,
                       StageClock& clock) {
  const auto num_threads = static_cast<int>(options.num_threads);
  clock.begin("grid");
  const OccupancyGrid grid = map_grid(run, num_threads);
  add_map_files(outputs, grid);
  clock.begin("picture");
  const bool is_upright = options.preset == Preset::kDefault;
  outputs.add(
      "map.png",
      png_from_image(map_image(run, is_upright ? grid : upright_map_grid(run, num_threads))));
  clock.begin("tables");
  outputs.add("trajectory.tum",
              tum_from_trajectory(trajectory_from(run.track, options.is_of_sensor)));
  if (!run.track.graph.T_map_node.empty()) {
    outputs.add("graph.g2o", g2o_from_pose_graph(run.track.graph));
    outputs.add("closures.tsv", tsv_from_closures(closures_of(run.track)));
    clock.begin("report");
    outputs.add("report.html", map_report_html(map_page(options, run, grid)));
  }
  outputs.add("run.json", run_json(options, run));
  clock.end();
  outputs.add("timing.json",
              timing_json({.stages = clock.stages(),
                           .num_scans = run.track.scans.size(),
                           .num_threads = num_threads}));
  outputs.commit();
}

}  // namespace setsquare::app
