// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// The steps of `setsquare simulate`: options, world, run, picture.
#pragma once

#include <CLI/App.hpp>
#include <cstddef>
#include <cstdint>
#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/setsquare/outputs/inputs.hpp"
#include "setsquare/core/trajectory.hpp"
#include "setsquare/sim/building/building.hpp"
#include "setsquare/sim/sensing/ray_casting.hpp"
#include "setsquare/sim/sensing/simulated_drive.hpp"

namespace setsquare::app {

/// What `setsquare simulate` was asked to do.
struct SimulateOptions {
  std::string output_path;                ///< A directory; made if it is not there.
  std::string building = "office";        ///< A class of buildings, "paper" or "hallway".
  std::uint64_t seed = 1;                 ///< Of the building and, apart from it, of the run.
  std::string plan_path;                  ///< Instead of a building; empty where none is given.
  double m_per_unit = 1.0;                ///< Of an SVG plan.
  std::string route;                      ///< "x,y x,y ..." in m; empty where none is given.
  std::optional<std::size_t> num_rounds;  ///< There and back; else one way, once.
  bool has_people = true;
  std::string scanner = "utm-30lx";
  std::optional<double> field_of_view_deg;
  std::optional<std::size_t> num_beams;
  std::optional<double> sweep_time_s;  ///< From a scan's first beam to its last.
  bool writes_json_lines = false;      ///< Instead of a CARMEN log.
  SimulatedDriveParams drive;          ///< But for seed and scanner: drive_from() sets them.
};

/// Adds the options. `options` must outlive the application.
void add_simulate_options(CLI::App& subcommand, SimulateOptions& options);

/// The name of the log that is written.
[[nodiscard]] std::string log_name(const SimulateOptions& options);

/// The drive that the options describe, with its scanner and seed. Throws ParameterError.
[[nodiscard]] SimulatedDriveParams drive_from(const SimulateOptions& options);

/// "x,y x,y ..." in m. Throws Error where it is no such list of two points or more, within 10 km.
[[nodiscard]] std::vector<Eigen::Vector2d> route_from_text(std::string_view text);

/// The building that the options name, or the plan with its route, driven in rounds where these are
/// wanted; without people where none are. Throws FileError, FormatError, Error where a plan has no
/// route.
[[nodiscard]] Building world_from(const SimulateOptions& options);

/// The files that world_from() reads: a plan, and the image that a map's yaml file names.
[[nodiscard]] InputPaths files_of_world(const SimulateOptions& options);

/// Throws Error with the place where a route leads through a wall.
void require_free_route(const RayCaster& caster, const std::vector<Eigen::Vector2d>& route_m);

/// A run through a world.
struct SimulatedRun {
  std::string log;             ///< The true pose before each scan.
  Trajectory truth;            ///< Of the base, one pose per scan, at the scan's stamp.
  Trajectory odometry;         ///< What the wheels say, likewise.
  double clutter_share = 0.0;  ///< Mean over the scans: furniture, clutter, people.
  std::size_t num_beams = 0;   ///< Of the first scan.
  double duration_s = 0.0;
  double length_m = 0.0;
};

/// Drives the route of the world and scans; shows how far it is. Several scanners take turns: at a
/// rate, evenly over its period, else one sweep after the other. Stamps count from the start, in
/// whole microseconds. Throws ParameterError, Error (more than a million scans, a route through a
/// wall of a plan, a rate that the scanner cannot hold).
[[nodiscard]] SimulatedRun run_simulation(const Building& world, const SimulateOptions& options);

/// The floor plan as an SVG document for people: materials by colour, people, where the robot was
/// truly, and a scale bar. y is up.
[[nodiscard]] std::string plan_picture(const Building& world,
                                       const Trajectory& truth,
                                       const std::string& caption);

}  // namespace setsquare::app
