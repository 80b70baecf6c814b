// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/setsquare/evaluate/closures_report.hpp"
#include "apps/setsquare/evaluate/evaluate.hpp"
#include "apps/setsquare/evaluate/reference.hpp"
#include "apps/setsquare/evaluate/statistics.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/eval/chained_reference.hpp"
#include "setsquare/eval/closure_judgement.hpp"
#include "setsquare/io/tables/closures_tsv.hpp"
#include "setsquare/io/tables/relations.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"

namespace setsquare::app {
namespace {

struct ClosuresOptions {
  std::string closures_path;
  std::string reference_path;
  std::string trajectory_path;  // empty: trajectory.tum beside the closures
  std::optional<ReferenceKind> kind;
  double max_time_difference_s = 0.0;
  bool is_list = false;
  bool is_json = false;
};

/// Poses in the map. Relations need them; against a true trajectory only closures of a single axis
/// do, so that one that was not named may be missing.
Trajectory read_map_trajectory(const ClosuresOptions& options, ReferenceKind kind) {
  if (!options.trajectory_path.empty()) return read_trajectory_tum(options.trajectory_path);
  const auto beside = std::filesystem::path(options.closures_path).parent_path() / "trajectory.tum";
  std::error_code is_missing;
  if (kind == ReferenceKind::kTrajectory && !std::filesystem::exists(beside, is_missing)) return {};
  return read_trajectory_tum(beside.string());
}

/// A pair of stamps that `poses` have, or the files do not belong together.
template <typename Pairs, typename FirstStamp, typename SecondStamp>
void require_known_stamps(const std::string& path,
                          const Pairs& pairs,
                          const FirstStamp& first,
                          const SecondStamp& second,
                          const PoseIndex& poses,
                          double tolerance_s) {
  const auto tolerance_ns = std::max(kSameStamp_ns, timestamp_from_seconds(tolerance_s).ns);
  const auto is_known = [&](const auto& pair) {
    return poses.find(pair.*first, tolerance_ns) && poses.find(pair.*second, tolerance_ns);
  };
  if (pairs.empty() || std::any_of(pairs.begin(), pairs.end(), is_known)) return;
  throw FormatError(path, "", "no line has both its stamps in the trajectory");
}

ReferencePoses expected_poses(const ClosuresOptions& options,
                              ReferenceKind kind,
                              const std::vector<LoopClosure>& closures,
                              const Trajectory& map_trajectory) {
  const auto require_closures = [&](const PoseIndex& poses, double tolerance_s) {
    require_known_stamps(options.closures_path,
                         closures,
                         &LoopClosure::stamp_i,
                         &LoopClosure::stamp_j,
                         poses,
                         tolerance_s);
  };
  if (kind == ReferenceKind::kTrajectory) {
    const Trajectory truth = read_trajectory_tum(options.reference_path);
    require_closures(PoseIndex(truth), options.max_time_difference_s);
    return expected_from_trajectory(truth, options.max_time_difference_s);
  }
  const std::vector<Relation> relations = read_relations(options.reference_path);
  const PoseIndex poses(map_trajectory);
  require_closures(poses, 0.0);
  require_known_stamps(options.reference_path,
                       relations,
                       &Relation::reference_stamp,
                       &Relation::current_stamp,
                       poses,
                       0.0);
  const auto chained = std::make_shared<ChainedReference>(relations, map_trajectory);
  return [chained](Timestamp stamp_i, Timestamp stamp_j) {
    return chained->expected(stamp_i, stamp_j);
  };
}

void evaluate_closures(const ClosuresOptions& options) {
  const std::vector<LoopClosure> closures = read_closures_tsv(options.closures_path);
  const ReferenceKind kind = options.kind ? *options.kind : reference_kind(options.reference_path);
  const Trajectory map_trajectory = read_map_trajectory(options, kind);
  const ReferencePoses expected = expected_poses(options, kind, closures, map_trajectory);
  const auto judgements = judge_closures(closures, expected, PoseIndex(map_trajectory));
  const ClosureSummary summary = summarise_closures(closures, judgements);
  if (options.is_json) {
    nlohmann::ordered_json json = json_from(summary);
    if (options.is_list) json["doubtful"] = json_of_doubtful(closures, judgements);
    std::cout << json.dump(2) << "\n";
    return;
  }
  std::cout << table_from(summary);
  if (options.is_list) std::cout << "\n" << list_of_doubtful(closures, judgements);
}

}  // namespace

void add_evaluate_closures(CLI::App& evaluate) {
  static const std::map<std::string, ReferenceKind> kNames{
      {"relations", ReferenceKind::kRelations}, {"trajectory", ReferenceKind::kTrajectory}};
  const auto options = std::make_shared<ClosuresOptions>();
  CLI::App* closures =
      evaluate.add_subcommand("closures", "How many loop closures of a map are wrong");
  closures->add_option("closures", options->closures_path, "closures.tsv of a map")->required();
  closures->add_option("reference", options->reference_path, "Relations, or the true trajectory")
      ->required();
  closures
      ->add_option("--trajectory",
                   options->trajectory_path,
                   "The map's trajectory, TUM format (default trajectory.tum beside the closures)")
      ->type_name("FILE");
  closures
      ->add_option("--reference-kind", options->kind, "What the reference is, if it is mistaken")
      ->transform(CLI::Transformer(kNames, CLI::ignore_case).description(""))
      ->type_name("relations|trajectory");
  add_time_difference_option(*closures, options->max_time_difference_s);
  closures->add_flag(
      "--list", options->is_list, "List the accepted ones wrong, borderline or disputed");
  closures->add_flag("--json", options->is_json, "Print JSON");
  closures->footer(
      "A closure is wrong where it is more than 0.3 m or 5 deg off; one of a single axis is "
      "judged\n"
      "along that axis of the map and by its rotation. Relations are chained: from i a short hop "
      "along\n"
      "the trajectory to a relation's stamp, relations whose noise adds up to less than a third of "
      "those\n"
      "limits, a short hop to j. A closure that they do not reach is unjudged; one that is nearer "
      "to the\n"
      "limits than two sigma of that noise is borderline; one on which two chains without a "
      "common\n"
      "relation disagree is disputed.\n"
      "Examples:\n"
      "  setsquare evaluate closures out/closures.tsv intel.relations --list\n"
      "  setsquare evaluate closures out/closures.tsv sim/truth.tum");
  closures->callback([options] { evaluate_closures(*options); });
}

}  // namespace setsquare::app
