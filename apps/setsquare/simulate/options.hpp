// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/App.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "setsquare/sim/sensing/robot_path.hpp"
#include "setsquare/sim/sensing/scanner_model.hpp"

namespace setsquare::app {

/// What `setsquare simulate` was asked to do.
struct SimulateOptions {
  std::string output_path;          ///< A directory; made if it is not there.
  std::string building = "office";  ///< A class of buildings, "paper" or "hallway".
  std::uint64_t seed = 1;           ///< Of the building and, apart from it, of the run.
  std::string plan_path;            ///< Instead of a building; empty where none is given.
  double m_per_unit = 1.0;          ///< Of an SVG plan.
  std::string route;                ///< "x,y x,y ..." in m; empty where none is given.
  bool has_people = true;
  std::string scanner = "utm-30lx";
  std::optional<double> field_of_view_deg;
  std::optional<std::size_t> num_beams;
  RobotSpeed speed;
  double scans_per_s = 10.0;
  std::optional<double> every_m;  ///< Instead of a rate: a scan after this way or every_deg.
  double every_deg = 10.0;
  bool has_drift = true;
};

/// Adds the options. `options` must outlive the application.
void add_simulate_options(CLI::App& subcommand, SimulateOptions& options);

/// The scanner that the options describe. Throws ParameterError, Error (more beams than a log can
/// hold).
[[nodiscard]] ScannerModel scanner_from(const SimulateOptions& options);

}  // namespace setsquare::app
