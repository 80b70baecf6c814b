// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare simulate -o DIR`: the log of a robot in a made-up building, and the truth about it.
#include "apps/setsquare/simulate/simulate.hpp"

#include <fmt/core.h>

#include <chrono>
#include <CLI/App.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "apps/setsquare/outputs/output_set.hpp"
#include "apps/setsquare/subcommands.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"

namespace setsquare::app {
namespace {

std::string name_of_world(const SimulateOptions& options) {
  if (!options.plan_path.empty()) {
    return std::filesystem::path(options.plan_path).filename().string();
  }
  return fmt::format("{}, seed {}", options.building, options.seed);
}

void tell(const SimulateOptions& options, const SimulatedRun& run, double elapsed_s) {
  std::cout << fmt::format(
      "{}: {} scans of {} beams, {:.0f} m driven in {:.0f} s; {:.0f} % of the returns from "
      "furniture, clutter and people\nsimulated in {:.2f} s ({:.0f} us per scan)\n"
      "written: {}/{}, truth.tum, plan.svg\n",
      name_of_world(options),
      run.truth.size(),
      run.num_beams,
      run.length_m,
      run.duration_s,
      100.0 * run.clutter_share,
      elapsed_s,
      1e6 * elapsed_s / static_cast<double>(run.truth.size()),
      options.output_path,
      log_name(options));
}

void simulate(const SimulateOptions& options) {
  using Clock = std::chrono::steady_clock;
  OutputSet outputs(options.output_path,
                    {"scans.clf", "scans.jsonl", "truth.tum", "plan.svg"},
                    files_of_world(options));
  const Building world = world_from(options);
  const auto start = Clock::now();
  const SimulatedRun run = run_simulation(world, options);
  const double elapsed_s = std::chrono::duration<double>(Clock::now() - start).count();
  outputs.add(log_name(options), run.log);
  outputs.add("truth.tum", tum_from_trajectory(run.truth));
  outputs.add("plan.svg", plan_picture(world, run.truth, name_of_world(options)));
  outputs.commit();
  tell(options, run, elapsed_s);
}

}  // namespace

void add_simulate(CLI::App& application) {
  CLI::App* simulate_command = application.add_subcommand(
      "simulate", "The log of a robot in a made-up building, with the truth");
  const auto options = std::make_shared<SimulateOptions>();
  add_simulate_options(*simulate_command, *options);
  simulate_command->footer(
      "Writes scans.clf (CARMEN: ROBOTLASER1, 2 ..., and TRUEPOS before each) or scans.jsonl, "
      "truth.tum (the "
      "robot's "
      "true\n"
      "pose at each scan, in the middle of the sweep) and plan.svg (the building and the way).\n"
      "The same options give the same files; all of them come at the end, or none.\n"
      "In an SVG plan the map's x is the drawing's x and the map's y its y turned up (-y), times\n"
      "--plan-scale; a class or data-material of wall, door, glass, pillar, furniture or clutter\n"
      "says what a shape or a group is made of. At most 16 MB and 500 000 lines of SVG, 100 "
      "million\n"
      "pixels of a map; the route must lie inside the plan.\n"
      "Examples:\n"
      "  setsquare simulate --building office --seed 7 -o sim\n"
      "  setsquare simulate --building wings --scanner low-cost-360 --no-people -o sim\n"
      "  setsquare simulate --building hallway --every 0.4 -o sim\n"
      "  setsquare simulate --building office --rounds 100 --beams 181 -o patrol\n"
      "  setsquare simulate --mounting 0.25,0.2,45 --mounting -0.25,-0.2,-135 -o sim\n"
      "  setsquare simulate --spin 360 --turn-rate 180 --scanner low-cost-360 --format jsonl -o "
      "sim\n"
      "  setsquare simulate --plan flat.svg --plan-scale 0.01 -o sim\n"
      "  setsquare simulate --plan map.yaml --route \"1,1 4,1 4,3\" -o sim");
  simulate_command->callback([options] { simulate(*options); });
}

}  // namespace setsquare::app
