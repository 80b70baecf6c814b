// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/simulate/options.hpp"

#include <CLI/Option.hpp>
#include <CLI/TypeTools.hpp>
#include <CLI/Validators.hpp>
#include <cmath>

#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/io/logs/record_stream.hpp"

namespace setsquare::app {
namespace {

/// Refuses what is not a finite number above 0, in plain words.
CLI::Validator above_zero() {
  return CLI::Validator(
      [](const std::string& text) {
        double value = 0.0;
        const bool is_number = CLI::detail::lexical_cast(text, value);
        const bool is_good = is_number && value > 0.0 && std::isfinite(value);
        return is_good ? std::string() : text + " is not a number above 0";
      },
      "");
}

/// CLI11 would read -1 as the largest number there is.
CLI::Validator no_minus() {
  return CLI::Validator(
      [](const std::string& text) {
        return text.starts_with('-') ? text + " is below 0" : std::string();
      },
      "");
}

void add_world_options(CLI::App& subcommand, SimulateOptions& options) {
  CLI::Option* const building =
      subcommand
          .add_option("--building",
                      options.building,
                      "Kind of building: office (default), hall, wings, corridor, round; paper and "
                      "hallway: like those of Bando et al. 2014")
          ->check(
              CLI::IsMember({"office", "hall", "wings", "corridor", "round", "paper", "hallway"})
                  .description(""))
          ->type_name("NAME");
  subcommand
      .add_option(
          "--seed", options.seed, "Another number, another building and another run (default: 1)")
      ->check(no_minus());
  CLI::Option* const plan =
      subcommand
          .add_option("--plan",
                      options.plan_path,
                      "A floor plan instead: .svg, or the .yaml of a map (map_server)")
          ->excludes(building);
  subcommand
      .add_option("--route",
                  options.route,
                  "The way through it, \"x,y x,y ...\" in m; an SVG may hold it as the line with "
                  "id=\"route\"")
      ->needs(plan);
  subcommand.add_option("--plan-scale", options.m_per_unit, "Metres that an SVG's unit stands for")
      ->check(above_zero())
      ->needs(plan);
  subcommand.add_flag("!--no-people", options.has_people, "Nobody stands or walks around");
}

void add_scanner_options(CLI::App& subcommand, SimulateOptions& options) {
  subcommand
      .add_option("--scanner",
                  options.scanner,
                  "utm-30lx (default: 1081 beams over 270 deg, 30 m) or low-cost-360 (about 360 "
                  "beams around, 8 m)")
      ->check(CLI::IsMember({"utm-30lx", "low-cost-360"}).description(""))
      ->type_name("NAME");
  subcommand.add_option("--field-of-view", options.field_of_view_deg, "Degrees that a scan covers");
  subcommand.add_option("--beams", options.num_beams, "Beams of a scan, evenly over it")
      ->check(no_minus());
}

void add_robot_options(CLI::App& subcommand, SimulateOptions& options) {
  subcommand
      .add_option("--speed", options.speed.drive_m_per_s, "Of the robot, in m/s (default: 0.5)")
      ->check(above_zero());
  CLI::Option* const rate =
      subcommand.add_option("--rate", options.scans_per_s, "Scans a second (default: 10)")
          ->check(above_zero());
  CLI::Option* const every =
      subcommand
          .add_option("--every",
                      options.every_m,
                      "Instead: a scan whenever the robot has moved this far, in m, or turned by "
                      "--every-angle")
          ->check(above_zero())
          ->excludes(rate);
  subcommand.add_option("--every-angle", options.every_deg, "In degrees (default: 10)")
      ->check(above_zero())
      ->needs(every);
  subcommand.add_flag("!--no-odometry-drift", options.has_drift, "Wheels that measure the truth");
}

}  // namespace

void add_simulate_options(CLI::App& subcommand, SimulateOptions& options) {
  subcommand
      .add_option("-o,--output", options.output_path, "Directory for the results; made if absent")
      ->required();
  add_world_options(subcommand, options);
  add_scanner_options(subcommand, options);
  add_robot_options(subcommand, options);
}

ScannerModel scanner_from(const SimulateOptions& options) {
  ScannerModel scanner = options.scanner == "low-cost-360" ? low_cost_360() : utm_30lx();
  if (options.field_of_view_deg) {
    scanner = with_field_of_view(scanner, rad_from_deg(*options.field_of_view_deg));
  }
  if (options.num_beams > std::size_t{kMaxBeams}) {
    throw Error("--beams: at most " + std::to_string(kMaxBeams));
  }
  if (options.num_beams) scanner = with_num_beams(scanner, *options.num_beams);
  return scanner;
}

}  // namespace setsquare::app
