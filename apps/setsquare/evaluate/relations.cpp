// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/io/tables/relations.hpp"

#include <fmt/core.h>

#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "apps/setsquare/evaluate/evaluate.hpp"
#include "apps/setsquare/evaluate/results.hpp"
#include "apps/setsquare/evaluate/statistics.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/eval/relation_error.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"
#include "setsquare/report/error_plots.hpp"

namespace setsquare::app {
namespace {

struct EvaluateRelationsOptions {
  std::string trajectory_path;
  std::string relations_path;
  bool is_json = false;
  ResultOptions results;
};

nlohmann::ordered_json json_from_relations(const MeanAndDeviation& statistic, double unit) {
  nlohmann::ordered_json json = {{"mean", unit * statistic.mean},
                                 {"deviation", unit * statistic.deviation}};
  if (statistic.mean_bound) json["mean_bound"] = json_of_bound(*statistic.mean_bound, unit);
  return json;
}

constexpr double kDegPerRad = deg_from_rad(1.0);

nlohmann::ordered_json json_from_relations(const RelationErrors& errors) {
  nlohmann::ordered_json json = {{"num_relations", errors.num_relations},
                                 {"translation_m", nullptr},
                                 {"squared_translation_m2", nullptr},
                                 {"rotation_deg", nullptr},
                                 {"squared_rotation_deg2", nullptr}};
  if (errors.num_relations == 0) return json;
  json["translation_m"] = json_from_relations(errors.translation_m, 1.0);
  json["squared_translation_m2"] = json_from_relations(errors.squared_translation_m2, 1.0);
  json["rotation_deg"] = json_from_relations(errors.rotation_rad, kDegPerRad);
  json["squared_rotation_deg2"] =
      json_from_relations(errors.squared_rotation_rad2, kDegPerRad * kDegPerRad);
  return json;
}

std::string json_text(const RelationErrorReport& report) {
  const nlohmann::ordered_json json = {{"all", json_from_relations(report.all)},
                                       {"under_60_s", json_from_relations(report.under_60_s)},
                                       {"from_60_s", json_from_relations(report.from_60_s)},
                                       {"num_missing", report.num_missing}};
  return json.dump(2) + "\n";
}

std::string tsv_cells(const MeanAndDeviation& statistic, double unit) {
  const std::string bound = statistic.mean_bound ? fmt::format("{:.6f}\t{:.6f}",
                                                               unit * statistic.mean_bound->low,
                                                               unit * statistic.mean_bound->high)
                                                 : "\t";
  return fmt::format(
      "\t{:.6f}\t{}\t{:.6f}", unit * statistic.mean, bound, unit * statistic.deviation);
}

std::string tsv_row_of_relations(const char* name, const RelationErrors& errors) {
  return fmt::format("{}\t{}", name, errors.num_relations) + tsv_cells(errors.translation_m, 1.0) +
         tsv_cells(errors.squared_translation_m2, 1.0) +
         tsv_cells(errors.rotation_rad, kDegPerRad) +
         tsv_cells(errors.squared_rotation_rad2, kDegPerRad * kDegPerRad) + "\n";
}

/// The table for papers: bounds in columns of their own.
std::string tsv_of_relations(const RelationErrorReport& report) {
  std::string text = "relations\tnumber";
  for (const char* error :
       {"translation_m", "squared_translation_m2", "rotation_deg", "squared_rotation_deg2"}) {
    text += fmt::format("\t{0}\t{0}_5\t{0}_95\t{0}_deviation", error);
  }
  return text + "\n" + tsv_row_of_relations("all", report.all) +
         tsv_row_of_relations("under_60_s", report.under_60_s) +
         tsv_row_of_relations("from_60_s", report.from_60_s);
}

void print_bounds(const char* name, const RelationErrors& errors) {
  const auto& translation_m = errors.translation_m.mean_bound;
  const auto& rotation_rad = errors.rotation_rad.mean_bound;
  if (errors.num_relations == 0 || !translation_m || !rotation_rad) return;
  std::cout << fmt::format("{:<16} translation {:.4f} to {:.4f} m, rotation {:.3f} to {:.3f} deg\n",
                           name,
                           translation_m->low,
                           translation_m->high,
                           deg_from_rad(rotation_rad->low),
                           deg_from_rad(rotation_rad->high));
}

void print_row(const char* name, const RelationErrors& errors) {
  std::cout << fmt::format("{:<16} {:9}   ", name, errors.num_relations);
  if (errors.num_relations == 0) {
    std::cout << fmt::format("{:^20} {:^22} {:^20} {:^20}\n", "-", "-", "-", "-");
    return;
  }
  std::cout << fmt::format(
      "{:8.4f} +- {:<8.4f} {:9.5f} +- {:<9.5f} {:8.3f} +- {:<8.3f} {:8.3f} +- {:<8.3f}\n",
      errors.translation_m.mean,
      errors.translation_m.deviation,
      errors.squared_translation_m2.mean,
      errors.squared_translation_m2.deviation,
      deg_from_rad(errors.rotation_rad.mean),
      deg_from_rad(errors.rotation_rad.deviation),
      kDegPerRad * kDegPerRad * errors.squared_rotation_rad2.mean,
      kDegPerRad * kDegPerRad * errors.squared_rotation_rad2.deviation);
}

void print_table(const RelationErrorReport& report) {
  std::cout << "relations            number   |translation| m        translation^2 m^2        "
               "|rotation| deg       rotation^2 deg^2\n";
  print_row("all", report.all);
  print_row("under 60 s apart", report.under_60_s);
  print_row("60 s and more", report.from_60_s);
  if (report.all.translation_m.mean_bound) {
    std::cout << "means, from 5 to 95 % by a block bootstrap:\n";
    print_bounds("all", report.all);
    print_bounds("under 60 s apart", report.under_60_s);
    print_bounds("60 s and more", report.from_60_s);
  }
  if (report.num_missing > 0) {
    std::cout << report.num_missing
              << " relations are left out: the trajectory has no pose at one of their stamps\n";
  }
}

void evaluate_relations(const EvaluateRelationsOptions& options) {
  const Trajectory trajectory = read_trajectory_tum(options.trajectory_path);
  const std::vector<Relation> relations = read_relations(options.relations_path);
  const RelationErrorReport report =
      relation_error(trajectory, relations, options.results.bootstrap());
  if (report.all.num_relations == 0) {
    throw FormatError(options.relations_path,
                      "",
                      "no relation has both its stamps in " + options.trajectory_path);
  }
  if (options.is_json) {
    std::cout << json_text(report);
  } else {
    print_table(report);
  }
  if (options.results.directory.empty()) return;
  const ErrorSeries errors = relation_errors(trajectory, relations).errors;
  write_results(options.results,
                {{"relations.tsv", tsv_of_relations(report)},
                 {"relations_errors.tsv", tsv_of(errors)},
                 {"relations_errors.svg",
                  error_plot_svg({errors.stamps, errors.translation_m, errors.rotation_rad})},
                 {"relations.json", json_text(report)}},
                {options.trajectory_path, options.relations_path},
                options.is_json ? nullptr : &std::cout);
}

}  // namespace

void add_evaluate_relations(CLI::App& evaluate) {
  const auto options = std::make_shared<EvaluateRelationsOptions>();
  CLI::App* relations = evaluate.add_subcommand(
      "relations", "Error of a trajectory by relations between poses (Kuemmerle et al. 2009)");
  relations->add_option("trajectory", options->trajectory_path, "Trajectory, TUM format")
      ->type_name("")
      ->required();
  relations->add_option("relations", options->relations_path, "Relations between poses")
      ->type_name("")
      ->required();
  relations->add_flag("--json", options->is_json, "Print JSON");
  add_result_options(*relations, options->results);
  relations->footer(
      "Errors in m and deg, mean and standard deviation, apart for relations within a minute and\n"
      "over more. \"-\" where no relation is of that kind. -o writes relations.json, relations.tsv "
      "(the\n"
      "table with its bounds), relations_errors.tsv and relations_errors.svg.\n"
      "Examples:\n"
      "  setsquare evaluate relations out/trajectory.tum intel.relations\n"
      "  setsquare evaluate relations out/trajectory.tum intel.relations --json");
  relations->callback([options] { evaluate_relations(*options); });
}

}  // namespace setsquare::app
