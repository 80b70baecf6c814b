// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "setsquare/io/map_file/map_file.hpp"
#include "setsquare/map/map.hpp"
#include "setsquare/report/map/run_json.hpp"

namespace setsquare {

struct SaveMapOptions {
  std::string title = "map";       ///< Of report.html.
  PoseOf pose_of = PoseOf::kBase;  ///< What trajectory.tum holds.
  int num_threads = 1;             ///< Any number gives the same files.
  RunRecord run = {};              ///< For run.json.
  /// Called before each stage: "grid", "picture", "tables" and "report". May be empty.
  std::function<void(const std::string& stage)> on_stage = {};
};

/// How to write a map that was loaded: the files are those that were written with it.
[[nodiscard]] SaveMapOptions save_options_of(const MapRecord& record);

/// Makes the files of a map one by one and gives each, by its name and bytes, to `add`:
/// map.pgm and map.yaml (nav2), map.png, trajectory.tum, pieces/N.tum for each piece of track that
/// is not joined (N from 1), poses.tsv, graph.g2o, closures.tsv and report.html (not for a map
/// without a graph), map.setsquare (the map itself, see load_map_file()), run.json. docs/formats.md
/// describes them. Throws ParameterError, and what `add` throws.
void make_map_files(
    const Map& map,
    const SaveMapOptions& options,
    const std::function<void(const std::string& name, std::string_view bytes)>& add);

/// map.png alone: the map for people, as PNG. Any number of threads gives the same bytes.
[[nodiscard]] std::string map_png(const Map& map, int num_threads = 1);

/// Writes the same files into a folder, which is made where it is absent, as `setsquare map` does
/// but for timing.json. None of the files changes before all are made; those of an older map that
/// this one does not have are removed; other files in the folder stay. Returns the names in their
/// order, run.json last. Throws FileError, ParameterError.
std::vector<std::string> save_map(const Map& map,
                                  const std::string& folder,
                                  const SaveMapOptions& options = {});

}  // namespace setsquare
