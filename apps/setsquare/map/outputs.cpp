// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/map/outputs.hpp"

#include "apps/setsquare/map/record.hpp"
#include "apps/setsquare/scans/log_options.hpp"
#include "setsquare/report/map/save_map.hpp"

namespace setsquare::app {

std::vector<std::string> map_output_names() {
  return {"trajectory.tum",
          "pieces/",
          "poses.tsv",
          "map.pgm",
          "map.yaml",
          "map.png",
          "graph.g2o",
          "closures.tsv",
          "report.html",
          "timing.json",
          "run.json"};
}

void write_map_outputs(OutputSet& outputs,
                       const MapOptions& options,
                       const MapRun& run,
                       StageClock& clock) {
  const auto num_threads = static_cast<int>(options.num_threads);
  make_map_files(
      run.map,
      {.title = title_of_log(options.log_name()),
       .pose_of = options.is_of_sensor ? PoseOf::kSensor : PoseOf::kBase,
       .num_threads = num_threads,
       .run = record_of(options, run),
       .on_stage = [&](const std::string& stage) { clock.begin(stage); }},
      [&](const std::string& name, std::string_view bytes) { outputs.add(name, bytes); });
  clock.end();
  outputs.add("timing.json",
              timing_json({.stages = clock.stages(),
                           .num_scans = run.map.scans.size(),
                           .num_threads = num_threads}));
  outputs.commit();
}

}  // namespace setsquare::app
