// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/map/outputs.hpp"

#include <fmt/core.h>

#include "setsquare/core/joined.hpp"
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
          kMapFileName,
          "run.json"};
}

void write_map_outputs(OutputSet& outputs,
                       const MappedLog& mapped,
                       PoseOf pose_of,
                       StageClock& clock) {
  SaveMapOptions options = save_options_of(mapped, pose_of);
  options.on_stage = [&](const std::string& stage) { clock.begin(stage); };
  make_map_files(mapped.map, options, [&](const std::string& name, std::string_view bytes) {
    outputs.add(name, bytes);
  });
  clock.end();
  outputs.add("timing.json",
              timing_json({.stages = clock.stages(),
                           .num_scans = mapped.map.scans.size(),
                           .num_threads = options.num_threads}));
  outputs.commit();
}

std::string written_text(const std::string& folder, const OutputSet& outputs) {
  return fmt::format("written: {}/{}\n", folder, joined(outputs.added()));
}

}  // namespace setsquare::app
