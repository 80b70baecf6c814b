// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/evaluate/statistics.hpp"

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <cstdio>

#include "setsquare/core/angle.hpp"

namespace setsquare::app {
namespace {

std::string row_from(const char* name, const ErrorStatistics& statistics, double unit) {
  char line[160];
  std::snprintf(line,
                sizeof line,
                "%-16s %10.4f %10.4f %10.4f %10.4f %10.4f\n",
                name,
                unit * statistics.mean,
                unit * statistics.rmse,
                unit * statistics.median,
                unit * statistics.max,
                unit * statistics.deviation);
  return line;
}

}  // namespace

nlohmann::ordered_json json_from(const ErrorStatistics& statistics, double unit) {
  return {{"mean", unit * statistics.mean},
          {"rmse", unit * statistics.rmse},
          {"median", unit * statistics.median},
          {"max", unit * statistics.max},
          {"deviation", unit * statistics.deviation}};
}

std::string table_from(const ErrorStatistics& translation_m, const ErrorStatistics& rotation_rad) {
  return "                       mean       rmse     median        max  deviation\n" +
         row_from("translation, m", translation_m, 1.0) +
         row_from("rotation, deg", rotation_rad, deg_from_rad(1.0));
}

void add_time_difference_option(CLI::App& subcommand, double& seconds) {
  seconds = 0.02;
  subcommand
      .add_option("--max-time-difference",
                  seconds,
                  "Poses at most this far apart in time are of one moment, s (default 0.02)")
      ->check(CLI::Range(0.0, 3600.0).description(""))
      ->type_name("S");
}

}  // namespace setsquare::app
