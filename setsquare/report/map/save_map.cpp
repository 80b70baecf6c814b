// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/report/map/save_map.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "setsquare/core/error.hpp"
#include "setsquare/core/numbered_files.hpp"
#include "setsquare/core/save_file.hpp"
#include "setsquare/drawing/png.hpp"
#include "setsquare/io/map_file/map_file.hpp"
#include "setsquare/io/maps/map_pgm_yaml.hpp"
#include "setsquare/io/tables/closures_tsv.hpp"
#include "setsquare/io/tables/pose_graph_g2o.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"
#include "setsquare/report/map/building_heading.hpp"
#include "setsquare/report/map/page.hpp"
#include "setsquare/report/map/picture.hpp"
#include "setsquare/report/map/poses_tsv.hpp"

namespace setsquare {
namespace {

/// map.png along the building's walls. The map's axes are others where no frame of the building was
/// measured (PaperMapper).
std::string png_of(const Map& map,
                   const OccupancyGrid& grid,
                   std::span<const LoopClosure> closures,
                   int num_threads) {
  const MapPictureLayers layers{.scans = map.scans,
                                .closures = closures,
                                .doubts = map.doubts,
                                .sessions = map.sessions,
                                .gaps = map.forgotten_poses};
  if (!map.frames.empty()) return png_from_image(layered_map_picture(grid, layers));
  const double walls_rad = building_heading_rad(placed_scans(map));
  return png_from_image(layered_map_picture(occupancy_grid(map, num_threads, walls_rad), layers));
}

}  // namespace

SaveMapOptions save_options_of(const MapRecord& record) {
  return {.title = record.title, .pose_of = record.pose_of, .run = record.run};
}

std::string map_png(const Map& map, int num_threads) {
  const OccupancyGrid grid = occupancy_grid(map, num_threads);
  return png_of(map, grid, closures_of(map), num_threads);
}

void make_map_files(
    const Map& map,
    const SaveMapOptions& options,
    const std::function<void(const std::string& name, std::string_view bytes)>& add) {
  const auto begin = [&](const char* stage) {
    if (options.on_stage) options.on_stage(stage);
  };
  begin("grid");
  const auto [grid, changes] = occupancy_grid_with_changes(map, options.num_threads);
  const MapFiles files = map_files_from_grid(grid, "map.pgm");
  add("map.pgm", files.pgm);
  add("map.yaml", files.yaml);
  begin("picture");
  const std::vector<LoopClosure> closures = closures_of(map);
  add("map.png", png_of(map, grid, closures, options.num_threads));
  begin("tables");
  add("trajectory.tum", tum_from_trajectory(trajectory_of(map, options.pose_of)));
  for (std::size_t k = 0; k < map.pieces.size(); ++k) {
    if (map.pieces[k].is_joined) continue;
    add("pieces/" + std::to_string(k + 1) + ".tum",
        tum_from_trajectory(trajectory_of(map, map.pieces[k], options.pose_of)));
  }
  add("poses.tsv", poses_tsv(map, options.pose_of));
  if (!map.graph.T_map_node.empty()) {
    add("graph.g2o", g2o_from_pose_graph(map.graph));
    add("closures.tsv", tsv_from_closures(closures));
    begin("report");
    add("report.html",
        map_report_html(
            {.title = options.title, .map = map, .grid = &grid, .figures = map_figures(map)}));
  }
  add(kMapFileName,
      map_file_bytes(map,
                     {.title = options.title, .pose_of = options.pose_of, .run = options.run}));
  add("run.json", run_json(map, options.run, options.pose_of, changes));
}

std::vector<std::string> save_map(const Map& map,
                                  const std::string& folder,
                                  const SaveMapOptions& options) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError(folder, "cannot be made: " + error.message());
  const std::filesystem::path pieces = std::filesystem::path(folder) / "pieces";
  const bool has_pieces =
      std::ranges::any_of(map.pieces, [](const TrackPiece& piece) { return !piece.is_joined; });
  if (has_pieces) std::filesystem::create_directories(pieces, error);
  if (error) throw FileError(pieces.string(), "cannot be made: " + error.message());
  std::vector<std::string> names;
  StagedFiles files;
  make_map_files(map, options, [&](const std::string& name, std::string_view bytes) {
    names.push_back(name);
    files.add((std::filesystem::path(folder) / name).string(), bytes);
  });
  files.commit();
  // A set is of one map: what the last one had and this one has not goes.
  for (const char* name : {"graph.g2o", "closures.tsv", "report.html", "timing.json"}) {
    if (std::ranges::find(names, name) != names.end()) continue;
    std::filesystem::remove(std::filesystem::path(folder) / name, error);
  }
  for (const std::string& name : numbered_tum_files(pieces)) {
    if (std::ranges::find(names, "pieces/" + name) != names.end()) continue;
    std::filesystem::remove(pieces / name, error);
  }
  // Not where it holds other files, nor what is no folder: that is not ours.
  if (!has_pieces &&
      std::filesystem::is_directory(std::filesystem::symlink_status(pieces, error))) {
    std::filesystem::remove(pieces, error);
  }
  return names;
}

}  // namespace setsquare
