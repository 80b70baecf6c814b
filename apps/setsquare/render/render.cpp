// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare render MAP -o DIR`: the outputs of a map again, from its file.
#include <algorithm>
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "apps/setsquare/audit/verdict_text.hpp"
#include "apps/setsquare/command_line/options.hpp"
#include "apps/setsquare/map/outputs.hpp"
#include "apps/setsquare/outputs/output_set.hpp"
#include "apps/setsquare/subcommands.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/io/map_file/map_file.hpp"
#include "setsquare/report/map/save_map.hpp"

namespace setsquare::app {
namespace {

namespace fs = std::filesystem;

struct RenderOptions {
  std::string map_path;     ///< A map file, or the folder of one.
  std::string output_path;  ///< A directory; empty: that of the map file.
  std::size_t num_threads = 0;
};

/// The outputs that are made in the folder. A map that lies there stays: it is the one that is
/// read, and then timing.json tells of its making. Throws FileError where it is another one, whose
/// outputs stand beside it.
std::vector<std::string> rendered_names(const fs::path& folder, const std::string& map_file) {
  std::vector<std::string> names = map_output_names();
  std::erase(names, kMapFileName);
  const fs::path there = folder / kMapFileName;
  std::error_code ignored;
  if (!fs::exists(there, ignored)) return names;
  if (!fs::equivalent(there, map_file, ignored)) {
    throw FileError(there.string(), "is another map, with its own outputs: choose another folder");
  }
  std::erase(names, "timing.json");
  return names;
}

void render_command(RenderOptions options) {
  if (options.num_threads == 0) {
    options.num_threads = std::max(1U, std::thread::hardware_concurrency());
  }
  const std::string map_file = map_file_at(options.map_path);
  const SavedMap saved = load_map_file(map_file);
  if (options.output_path.empty()) {
    const fs::path folder = fs::path(map_file).parent_path();
    options.output_path = folder.empty() ? "." : folder.string();
  }
  OutputSet outputs(options.output_path, rendered_names(options.output_path, map_file), {map_file});
  SaveMapOptions how = save_options_of(saved.record);
  how.num_threads = static_cast<int>(options.num_threads);
  make_map_files(saved.map, how, [&](const std::string& name, std::string_view bytes) {
    if (name != kMapFileName) outputs.add(name, bytes);
  });
  outputs.commit();
  std::cout << verdict_text(saved.map) << written_text(options.output_path, outputs);
}

}  // namespace

void add_render(CLI::App& application) {
  const auto options = std::make_shared<RenderOptions>();
  CLI::App* render = application.add_subcommand(
      "render", "Make the outputs of a map again, from its file, without the log");
  render->add_option("map", options->map_path, "map.setsquare, or the folder that `map` wrote")
      ->type_name("")
      ->required();
  render
      ->add_option("-o,--output", options->output_path, "Directory for the results; made if absent")
      ->type_name("DIR")
      ->default_str("that of the map");
  render->add_option("--threads", options->num_threads, "Threads; any number gives the same files")
      ->check(whole_number(1, 1024))
      ->type_name("N")
      ->default_str("one per processor");
  render->footer(
      "Writes what `setsquare map` wrote, byte for byte where the same Setsquare does it, but for\n"
      "timing.json; the map itself is only read. All of the files come at the end, or none.\n"
      "Examples:\n"
      "  setsquare render out/map.setsquare -o out2\n"
      "  setsquare render out                        # those that were lost, in place\n"
      "  setsquare info out/map.setsquare            # what is in it");
  render->callback([options] { render_command(*options); });
}

}  // namespace setsquare::app
