// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "apps/setsquare/simulate/simulate.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/io/bytes/byte_source.hpp"
#include "setsquare/io/bytes/text_scanner.hpp"
#include "setsquare/io/maps/map_pgm_yaml.hpp"
#include "setsquare/io/maps/map_yaml.hpp"
#include "setsquare/sim/floor_plan_from_cells.hpp"
#include "setsquare/sim/svg/floor_plan_svg.hpp"

namespace setsquare::app {
namespace {

std::string text_of(const std::string& path) {
  constexpr std::size_t kMaxBytes = std::size_t{1} << 25;
  const auto source = open_regular_file_source(path);
  std::string text;
  std::vector<char> piece(std::size_t{1} << 16);
  while (const std::size_t num_bytes = source->read(piece)) {
    text.append(piece.data(), num_bytes);
    if (text.size() > kMaxBytes) throw FileError(path, "too long for a floor plan");
  }
  return text;
}

/// What a map knows to be occupied is a wall.
FloorPlan plan_from_grid(const OccupancyGrid& grid) {
  PlanCells cells;
  cells.T_map_cells = grid.T_map_grid();
  cells.resolution_m = grid.resolution_m();
  cells.num_columns = static_cast<std::size_t>(grid.num_columns());
  cells.num_rows = static_cast<std::size_t>(grid.num_rows());
  cells.is_filled.resize(grid.values().size());
  std::transform(
      grid.values().begin(), grid.values().end(), cells.is_filled.begin(), [](float log_odds) {
        return static_cast<std::uint8_t>(log_odds > 0.0F);
      });
  return floor_plan_from_cells(cells);
}

bool is_map_yaml(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension == ".yaml" || extension == ".yml";
}

/// Throws Error where a corner of the route lies outside the map's image or in an occupied cell.
void require_free_corners(const OccupancyGrid& grid, const std::vector<Eigen::Vector2d>& route_m) {
  const Pose2 T_grid_map = grid.T_map_grid().inverse();
  for (const Eigen::Vector2d& corner_m : route_m) {
    const Eigen::Vector2d cell = (T_grid_map * corner_m) / grid.resolution_m();
    const bool is_inside =
        cell.minCoeff() >= 0.0 && cell.x() < grid.num_columns() && cell.y() < grid.num_rows();
    const auto place = fmt::format("{:.2f},{:.2f}", corner_m.x(), corner_m.y());
    if (!is_inside) throw Error("the route leaves the map at " + place);
    const CellIndex index{static_cast<std::int32_t>(cell.x()), static_cast<std::int32_t>(cell.y())};
    if (grid.state(index) == CellState::kOccupied) {
      throw Error("the route stands in a wall at " + place);
    }
  }
}

/// Throws Error where a corner of the route lies outside all that is drawn.
void require_inside(const FloorPlan& plan, const std::vector<Eigen::Vector2d>& route_m) {
  Eigen::AlignedBox2d drawn;
  for (const PlanSegment& segment : plan.segments)
    drawn.extend(segment.start_m).extend(segment.end_m);
  for (const Eigen::Vector2d& corner_m : route_m) {
    if (drawn.contains(corner_m)) continue;
    throw Error(
        fmt::format("the route leaves the plan at {:.2f},{:.2f}", corner_m.x(), corner_m.y()));
  }
}

Building world_from_plan(const SimulateOptions& options) {
  const std::string& path = options.plan_path;
  Building world;
  std::optional<OccupancyGrid> grid;
  if (std::filesystem::path(path).extension() == ".svg") {
    SvgPlanParams params;
    params.m_per_unit = options.m_per_unit;
    SvgPlan svg = floor_plan_from_svg(text_of(path), path, params);
    world.plan = std::move(svg.plan);
    world.route_m = std::move(svg.route_m);
  } else if (is_map_yaml(path)) {
    grid = read_map_pgm_yaml(path);
    world.plan = plan_from_grid(*grid);
    if (world.plan.segments.empty()) throw FormatError(path, "", "not one occupied cell");
  } else {
    throw FileError(path, "a plan's name must end in .svg, .yaml or .yml");
  }
  if (!options.route.empty()) world.route_m = route_from_text(options.route);
  if (world.route_m.empty()) throw FileError(path, "no route: give --route \"x,y x,y ...\"");
  if (grid) require_free_corners(*grid, world.route_m);
  require_inside(world.plan, world.route_m);
  return world;
}

/// The way there and back, so many times.
std::vector<Eigen::Vector2d> driven_in_rounds(const std::vector<Eigen::Vector2d>& way_m,
                                              std::size_t num_rounds) {
  std::vector<Eigen::Vector2d> route_m{way_m.front()};
  for (std::size_t round = 0; round < num_rounds; ++round) {
    route_m.insert(route_m.end(), way_m.begin() + 1, way_m.end());
    route_m.insert(route_m.end(), way_m.rbegin() + 1, way_m.rend());
  }
  return route_m;
}

}  // namespace

std::vector<Eigen::Vector2d> route_from_text(std::string_view text) {
  constexpr double kFarthest_m = 10'000.0;
  std::string blanks(text);
  std::replace(blanks.begin(), blanks.end(), ',', ' ');
  TextScanner scanner(blanks);
  std::vector<Eigen::Vector2d> route_m;
  while (!scanner.is_at_end()) {
    const auto x_m = scanner.finite_number();
    const auto y_m = x_m ? scanner.finite_number() : std::nullopt;
    if (!y_m || std::max(std::abs(*x_m), std::abs(*y_m)) > kFarthest_m) {
      throw Error(
          fmt::format("--route: point {} is not \"x,y\" in m, within 10 km", route_m.size() + 1));
    }
    route_m.emplace_back(*x_m, *y_m);
  }
  if (route_m.size() < 2) throw Error("--route: must have two points or more");
  return route_m;
}

Building world_from(const SimulateOptions& options) {
  Building world = options.plan_path.empty() ? make_building(options.building, options.seed)
                                             : world_from_plan(options);
  if (options.num_rounds) world.route_m = driven_in_rounds(world.route_m, *options.num_rounds);
  if (!options.has_people) world.people.clear();
  return world;
}

InputPaths files_of_world(const SimulateOptions& options) {
  if (options.plan_path.empty()) return {};
  InputPaths files{options.plan_path};
  if (!is_map_yaml(options.plan_path)) return files;
  const std::string text = text_of(options.plan_path);
  const std::filesystem::path folder = std::filesystem::path(options.plan_path).parent_path();
  files.push_back((folder / map_yaml_from_text(text, options.plan_path).image).string());
  return files;
}

void require_free_route(const RayCaster& caster, const std::vector<Eigen::Vector2d>& route_m) {
  for (std::size_t i = 1; i < route_m.size(); ++i) {
    const Eigen::Vector2d way_m = route_m[i] - route_m[i - 1];
    const double length_m = way_m.norm();
    if (length_m == 0.0) continue;
    const Eigen::Vector2d direction = way_m / length_m;
    const auto hit = caster.cast(route_m[i - 1], direction, length_m);
    if (!hit) continue;
    const Eigen::Vector2d place_m = route_m[i - 1] + hit->range_m * direction;
    throw Error(fmt::format(
        "the route leads through a wall at {:.2f},{:.2f} (piece {})", place_m.x(), place_m.y(), i));
  }
}

}  // namespace setsquare::app
