// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/evaluate/statistics.hpp"

#include <fmt/core.h>

#include <CLI/Option.hpp>

#include "apps/setsquare/command_line/options.hpp"
#include "setsquare/core/angle.hpp"

namespace setsquare::app {
namespace {

std::string bound_row(const char* name,
                      const ErrorBounds& bounds,
                      double ErrorBound::*side,
                      double unit) {
  return fmt::format("{:<16} {:10.4f} {:10.4f} {:10.4f} {:>10} {:10.4f}\n",
                     name,
                     unit * bounds.mean.*side,
                     unit * bounds.rmse.*side,
                     unit * bounds.median.*side,
                     "-",
                     unit * bounds.deviation.*side);
}

std::string statistics_row(const char* name, const ErrorStatistics& statistics, double unit) {
  if (statistics.num_values == 0) {
    return fmt::format(
        "{:<16} {:>10} {:>10} {:>10} {:>10} {:>10}\n", name, "-", "-", "-", "-", "-");
  }
  const std::string row = fmt::format("{:<16} {:10.4f} {:10.4f} {:10.4f} {:10.4f} {:10.4f}\n",
                                      name,
                                      unit * statistics.mean,
                                      unit * statistics.rmse,
                                      unit * statistics.median,
                                      unit * statistics.max,
                                      unit * statistics.deviation);
  if (!statistics.bounds) return row;
  return row + bound_row("     from 5 %", *statistics.bounds, &ErrorBound::low, unit) +
         bound_row("     to 95 %", *statistics.bounds, &ErrorBound::high, unit);
}

std::string sentence_on_bounds(const ErrorStatistics& translation_m,
                               const ErrorStatistics& rotation_rad) {
  if (!translation_m.bounds || !rotation_rad.bounds) return "";
  return fmt::format("bounds by a block bootstrap: blocks of {} and {} errors\n",
                     translation_m.bounds->block_length,
                     rotation_rad.bounds->block_length);
}

std::string tsv_row(const char* name, const ErrorStatistics& statistics, double unit) {
  std::string row = fmt::format("{}\t{}", name, statistics.num_values);
  const auto append = [&](double value, const ErrorBound* bound) {
    row += fmt::format("\t{:.6f}", unit * value);
    row += bound ? fmt::format("\t{:.6f}\t{:.6f}", unit * bound->low, unit * bound->high) : "\t\t";
  };
  const ErrorBounds* bounds = statistics.bounds ? &*statistics.bounds : nullptr;
  append(statistics.mean, bounds ? &bounds->mean : nullptr);
  append(statistics.rmse, bounds ? &bounds->rmse : nullptr);
  append(statistics.median, bounds ? &bounds->median : nullptr);
  append(statistics.deviation, bounds ? &bounds->deviation : nullptr);
  return row + fmt::format("\t{:.6f}\n", unit * statistics.max);
}

}  // namespace

nlohmann::ordered_json json_of_statistics(const ErrorStatistics& statistics, double unit) {
  if (statistics.num_values == 0) return nullptr;
  nlohmann::ordered_json json = {{"mean", unit * statistics.mean},
                                 {"rmse", unit * statistics.rmse},
                                 {"median", unit * statistics.median},
                                 {"max", unit * statistics.max},
                                 {"deviation", unit * statistics.deviation}};
  if (const auto& bounds = statistics.bounds) {
    json["bounds"] = {{"mean", json_of_bound(bounds->mean, unit)},
                      {"rmse", json_of_bound(bounds->rmse, unit)},
                      {"median", json_of_bound(bounds->median, unit)},
                      {"deviation", json_of_bound(bounds->deviation, unit)},
                      {"block_length", bounds->block_length}};
  }
  return json;
}

nlohmann::ordered_json json_of_bound(const ErrorBound& bound, double unit) {
  return nlohmann::ordered_json::array({unit * bound.low, unit * bound.high});
}

std::string statistics_table(const ErrorStatistics& translation_m,
                             const ErrorStatistics& rotation_rad) {
  return "                       mean       rmse     median        max  deviation\n" +
         statistics_row("translation, m", translation_m, 1.0) +
         statistics_row("rotation, deg", rotation_rad, deg_from_rad(1.0)) +
         sentence_on_bounds(translation_m, rotation_rad);
}

std::string statistics_tsv(const ErrorStatistics& translation_m,
                           const ErrorStatistics& rotation_rad) {
  return "error\tnumber\tmean\tmean_5\tmean_95\trmse\trmse_5\trmse_95\tmedian\tmedian_5\t"
         "median_95\tdeviation\tdeviation_5\tdeviation_95\tmax\n" +
         tsv_row("translation_m", translation_m, 1.0) +
         tsv_row("rotation_deg", rotation_rad, deg_from_rad(1.0));
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
