// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare merge MAP MAP... -o DIR`: one map of several.
#include <algorithm>
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "apps/setsquare/audit/verdict_text.hpp"
#include "apps/setsquare/command_line/options.hpp"
#include "apps/setsquare/map/outputs.hpp"
#include "apps/setsquare/outputs/output_set.hpp"
#include "apps/setsquare/subcommands.hpp"
#include "setsquare/pipeline/merge_maps.hpp"
#include "setsquare/pipeline/run_sentences.hpp"
#include "setsquare/report/map/save_map.hpp"

namespace setsquare::app {
namespace {

struct MergeOptions {
  std::vector<std::string> map_paths;  ///< Map files, or the folders of them.
  std::string output_path;
  std::size_t num_threads = 0;
};

void merge_command(MergeOptions options) {
  if (options.num_threads == 0) {
    options.num_threads = std::max(1U, std::thread::hardware_concurrency());
  }
  std::vector<std::string> inputs;
  for (const std::string& path : options.map_paths) inputs.push_back(map_file_at(path));
  std::vector<std::string> names = map_output_names();
  std::erase(names, "timing.json");
  OutputSet outputs(options.output_path, names, inputs);
  const SavedMap merged = merge_map_files(options.map_paths, options.num_threads);
  SaveMapOptions how = save_options_of(merged.record);
  how.num_threads = static_cast<int>(options.num_threads);
  make_map_files(merged.map, how, [&](const std::string& name, std::string_view bytes) {
    outputs.add(name, bytes);
  });
  outputs.commit();
  std::cout << verdict_text(merged.map);
  for (const std::string& sentence : sentences_on_sessions(merged.map)) {
    std::cout << sentence << "\n";
  }
  std::cout << written_text(options.output_path, outputs);
}

}  // namespace

void add_merge(CLI::App& application) {
  const auto options = std::make_shared<MergeOptions>();
  CLI::App* merge = application.add_subcommand(
      "merge", "Merge maps of the same building into one, found by the places that they share");
  merge
      ->add_option(
          "maps", options->map_paths, "map.setsquare, or the folder that `map` wrote; two at least")
      ->type_name("")
      ->expected(2, -1)
      ->required();
  merge
      ->add_option("-o,--output", options->output_path, "Directory for the results; made if absent")
      ->type_name("DIR")
      ->required();
  merge->add_option("--threads", options->num_threads, "Threads; any number gives the same map")
      ->check(whole_number(1, 1024))
      ->type_name("N")
      ->default_str("one per processor");
  merge->footer(
      "Nothing needs to be known of how the maps lie to each other: places that they share are\n"
      "found, loops closed from map to map, and all poses solved again. The axes and the origin "
      "are\n"
      "those of the first. A map that shares no place with the first ones is refused, with the\n"
      "reason and exit code 2, and nothing is written. What two maps share, a log that both were\n"
      "made of, counts once. Where walls changed, the map whose stamps are later counts, or, "
      "where\n"
      "their times overlap, the one that is named later; run.json tells the places.\n"
      "Writes what `setsquare map` writes, but for timing.json.\n"
      "Examples:\n"
      "  setsquare merge ground_floor_east ground_floor_west -o ground_floor\n"
      "  setsquare merge monday/map.setsquare tuesday/map.setsquare wednesday/map.setsquare -o "
      "week");
  merge->callback([options] { merge_command(*options); });
}

}  // namespace setsquare::app
