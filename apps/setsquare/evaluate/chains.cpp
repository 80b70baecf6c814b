// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/Option.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "apps/setsquare/evaluate/closures_report.hpp"
#include "apps/setsquare/evaluate/evaluate.hpp"
#include "apps/setsquare/evaluate/statistics.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/eval/chained_reference.hpp"
#include "setsquare/io/tables/relations.hpp"

namespace setsquare::app {
namespace {

struct ChainsOptions {
  std::string relations_path;
  bool is_json = false;
};

void evaluate_chains(const ChainsOptions& options) {
  const ChainCheckParams params;
  const ChainCheck check = check_chains(read_relations(options.relations_path), params);
  if (options.is_json) {
    nlohmann::ordered_json json = json_from(check.verdicts);
    json["translation_m"] = json_from(check.translation_m, 1.0);
    json["rotation_deg"] = json_from(check.rotation_rad, deg_from_rad(1.0));
    std::cout << json.dump(2) << "\n";
    return;
  }
  const ClosureCounts& verdicts = check.verdicts;
  std::cout << verdicts.num_closures << " relations between stamps " << params.min_time_s
            << " s and more apart, each judged by chains of the others:\n"
            << verdicts.num_right << " right, " << verdicts.num_wrong << " wrong, "
            << verdicts.num_borderline << " borderline, " << verdicts.num_disputed << " disputed, "
            << verdicts.num_unjudged << " out of reach; the chains' errors:\n"
            << table_from(check.translation_m, check.rotation_rad);
}

}  // namespace

void add_evaluate_chains(CLI::App& evaluate) {
  const auto options = std::make_shared<ChainsOptions>();
  CLI::App* chains = evaluate.add_subcommand(
      "chains", "How well chains of relations foretell a relation: whether to believe `closures`");
  chains->add_option("relations", options->relations_path, "Relations")->required();
  chains->add_flag("--json", options->is_json, "Print JSON");
  chains->footer("Example:\n  setsquare evaluate chains intel.relations");
  chains->callback([options] { evaluate_chains(*options); });
}

}  // namespace setsquare::app
