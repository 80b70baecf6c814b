// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/evaluate/statistics.hpp"

#include <fmt/format.h>

#include <CLI/Option.hpp>

#include "apps/setsquare/command_line/options.hpp"
#include "setsquare/core/angle.hpp"

namespace setsquare::app {
namespace {

std::string statistics_row(const char* name, const ErrorStatistics& statistics, double unit) {
  if (statistics.num_values == 0) {
    return fmt::format(
        "{:<16} {:>10} {:>10} {:>10} {:>10} {:>10}\n", name, "-", "-", "-", "-", "-");
  }
  return fmt::format("{:<16} {:10.4f} {:10.4f} {:10.4f} {:10.4f} {:10.4f}\n",
                     name,
                     unit * statistics.mean,
                     unit * statistics.rmse,
                     unit * statistics.median,
                     unit * statistics.max,
                     unit * statistics.deviation);
}

}  // namespace

nlohmann::ordered_json json_of_statistics(const ErrorStatistics& statistics, double unit) {
  if (statistics.num_values == 0) return nullptr;
  return {{"mean", unit * statistics.mean},
          {"rmse", unit * statistics.rmse},
          {"median", unit * statistics.median},
          {"max", unit * statistics.max},
          {"deviation", unit * statistics.deviation}};
}

std::string statistics_table(const ErrorStatistics& translation_m,
                             const ErrorStatistics& rotation_rad) {
  return "                       mean       rmse     median        max  deviation\n" +
         statistics_row("translation, m", translation_m, 1.0) +
         statistics_row("rotation, deg", rotation_rad, deg_from_rad(1.0));
}

void add_time_difference_option(CLI::App& subcommand, double& seconds) {
  seconds = 0.02;
  subcommand
      .add_option(
          "--max-time-difference", seconds, "Largest difference of two stamps of the same moment")
      ->check(number_from(0.0, 3600.0))
      ->type_name("S");
}

}  // namespace setsquare::app
