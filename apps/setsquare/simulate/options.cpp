// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/command_line/options.hpp"

#include <CLI/Option.hpp>
#include <cstdint>
#include <limits>

#include "apps/setsquare/scans/mounting_text.hpp"
#include "apps/setsquare/simulate/simulate.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/io/logs/record_stream.hpp"

namespace setsquare::app {
namespace {

constexpr int kMaxScanners = 9;  // ROBOTLASER1 to ROBOTLASER9
constexpr double kFastestTurn_deg_per_s = 36000.0;
constexpr double kWidestSpin_deg = 36000.0;
constexpr double kRestAtSpin_s = 1.0;
constexpr std::size_t kMaxRounds = 100'000;

void add_world_options(CLI::App& subcommand, SimulateOptions& options) {
  CLI::Option* const building =
      subcommand
          .add_option("--building",
                      options.building,
                      "Kind of building; paper and hallway: like those of Bando et al. 2014")
          ->transform(one_of({"office", "hall", "wings", "corridor", "round", "paper", "hallway"}))
          ->type_name("office|hall|wings|corridor|round|paper|hallway");
  subcommand.add_option("--seed", options.seed, "Another number: another building and another run")
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->type_name("N");
  CLI::Option* const plan =
      subcommand
          .add_option(
              "--plan",
              options.plan_path,
              "Instead of --building: a floor plan, .svg or the .yaml of a map (map_server)")
          ->type_name("FILE")
          ->excludes(building);
  subcommand
      .add_option(
          "--route",
          options.route,
          "With --plan: the way through it, \"x,y x,y ...\" in m; an SVG may hold it as the "
          "line with id=\"route\"")
      ->type_name("POINTS")
      ->needs(plan);
  subcommand
      .add_option(
          "--plan-scale", options.m_per_unit, "With --plan: metres that an SVG's unit stands for")
      ->check(number_above(0.0))
      ->type_name("M")
      ->needs(plan);
  subcommand.add_flag_callback(
      "--no-people", [&options] { options.has_people = false; }, "Nobody stands or walks around");
}

void add_scanner_options(CLI::App& subcommand, SimulateOptions& options) {
  subcommand
      .add_option("--scanner",
                  options.scanner,
                  "utm-30lx: 1081 beams over 270 deg, 30 m; low-cost-360: about 360 beams around, "
                  "8 m")
      ->transform(one_of({"utm-30lx", "low-cost-360"}))
      ->type_name("utm-30lx|low-cost-360");
  subcommand.add_option("--field-of-view", options.field_of_view_deg, "Angle that a scan covers")
      ->check(number_above(0.0, 360.0))
      ->type_name("DEG")
      ->default_str("the scanner's");
  subcommand.add_option("--beams", options.num_beams, "Beams of a scan, evenly over it")
      ->check(whole_number(2, kMaxBeams))
      ->type_name("N")
      ->default_str("the scanner's");
  subcommand
      .add_option("--sweep-time",
                  options.sweep_time_s,
                  "From the first beam to the last, while the robot moves; 0: all at once")
      ->check(number_from(0.0, 10.0))
      ->type_name("S")
      ->default_str("the scanner's");
  CLI::Option* const mounting =
      subcommand
          .add_option_function<std::vector<std::string>>(
              "--mounting",
              [&options](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) {
                  options.drive.T_base_sensor.push_back(mounting_from_text("--mounting", text));
                }
              },
              "Where a scanner is on the robot, turned by DEG; repeated for each further one")
          ->expected(1, kMaxScanners)
          ->type_name("X,Y,DEG")
          ->default_str("0,0,0");
  subcommand
      .add_option_function<std::string>(
          "--mounting-error",
          [&options](const std::string& text) {
            options.drive.T_stated_true = mounting_from_text("--mounting-error", text);
          },
          "Where the last scanner truly is, seen from the mounting that the log states")
      ->type_name("X,Y,DEG")
      ->default_str("0,0,0")
      ->needs(mounting);
}

void add_motion_options(CLI::App& subcommand, SimulateOptions& options) {
  subcommand
      .add_option("--rounds", options.num_rounds, "Patrols: drives the way there and back, N times")
      ->check(whole_number(1, kMaxRounds))
      ->type_name("N")
      ->default_str("one way, once");
  subcommand.add_option("--speed", options.drive.speed.drive_m_per_s, "Of the robot, in m/s")
      ->check(number_above(0.0))
      ->type_name("M/S");
  subcommand
      .add_option_function<double>(
          "--turn-rate",
          [&options](double deg_per_s) {
            options.drive.speed.turn_rad_per_s = rad_from_deg(deg_per_s);
          },
          "How fast it turns on the spot and, at most, in corners")
      ->check(number_above(0.0, kFastestTurn_deg_per_s))
      ->type_name("DEG_PER_S")
      ->default_str("28.6");
  subcommand
      .add_option_function<double>(
          "--spin",
          [&options](double deg) {
            options.drive.turn_at_start = {.turn_rad = rad_from_deg(deg), .rest_s = kRestAtSpin_s};
          },
          "Before it drives off it turns on the spot, by so much, and rests before and after")
      ->check(number_from(-kWidestSpin_deg, kWidestSpin_deg))
      ->type_name("DEG")
      ->default_str("0");
}

void add_robot_options(CLI::App& subcommand, SimulateOptions& options) {
  add_motion_options(subcommand, options);
  CLI::Option* const rate =
      subcommand.add_option("--rate", options.drive.scans_per_s, "Scans per second")
          ->check(number_above(0.0))
          ->type_name("HZ");
  CLI::Option* const every = subcommand
                                 .add_option("--every",
                                             options.drive.every_m,
                                             "Instead of --rate: a scan whenever the robot has "
                                             "moved this far, or turned by --every-angle")
                                 ->check(number_above(0.0))
                                 ->type_name("M")
                                 ->excludes(rate);
  subcommand
      .add_option_function<double>(
          "--every-angle",
          [&options](double deg) { options.drive.every_rad = rad_from_deg(deg); },
          "With --every: the turn")
      ->check(number_above(0.0))
      ->type_name("DEG")
      ->default_str("10")
      ->needs(every);
  subcommand.add_flag_callback(
      "--no-odometry-drift",
      [&options] { options.drive.has_drift = false; },
      "Wheels that measure the truth");
}

}  // namespace

void add_simulate_options(CLI::App& subcommand, SimulateOptions& options) {
  subcommand
      .add_option("-o,--output", options.output_path, "Directory for the results; made if absent")
      ->type_name("DIR")
      ->required();
  add_choice<bool, bool>(subcommand,
                         "--format",
                         options.writes_json_lines,
                         {{"clf", false}, {"jsonl", true}},
                         "Of the log: CARMEN, or JSON lines, which state the sweep time",
                         "clf");
  add_world_options(subcommand, options);
  add_scanner_options(subcommand, options);
  add_robot_options(subcommand, options);
}

std::string log_name(const SimulateOptions& options) {
  return options.writes_json_lines ? "scans.jsonl" : "scans.clf";
}

SimulatedDriveParams drive_from(const SimulateOptions& options) {
  SimulatedDriveParams drive = options.drive;
  drive.seed = options.seed;
  drive.scanner = scanner_named(options.scanner);
  if (options.field_of_view_deg) {
    drive.scanner = with_field_of_view(drive.scanner, rad_from_deg(*options.field_of_view_deg));
  }
  if (options.num_beams) drive.scanner = with_num_beams(drive.scanner, *options.num_beams);
  if (options.sweep_time_s) drive.scanner.sweep_s = *options.sweep_time_s;
  return drive;
}

}  // namespace setsquare::app
