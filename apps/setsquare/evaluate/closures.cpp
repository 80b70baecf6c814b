// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// `setsquare evaluate closures` and `evaluate chains`: which loop closures are wrong, and whether
// the chains of relations that say so are reliable.
#include <fmt/core.h>

#include <algorithm>
#include <CLI/Option.hpp>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "apps/setsquare/command_line/options.hpp"
#include "apps/setsquare/evaluate/evaluate.hpp"
#include "apps/setsquare/evaluate/statistics.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/eval/chained_reference.hpp"
#include "setsquare/eval/closure_judgement.hpp"
#include "setsquare/io/tables/closures_tsv.hpp"
#include "setsquare/io/tables/number_table.hpp"
#include "setsquare/io/tables/relations.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"

namespace setsquare::app {
namespace {

using Json = nlohmann::ordered_json;

/// Of the judged closures; meaningless where there is none.
double wrong_share(const ClosureCounts& counts) {
  return static_cast<double>(counts.num_wrong) / static_cast<double>(counts.num_judged());
}

std::string closure_row(const char* name, const ClosureCounts& counts) {
  const std::string share =
      counts.num_judged() > 0 ? fmt::format("{:.2f} %", 100.0 * wrong_share(counts)) : "-";
  return fmt::format("{:<10} {:8} {:9} {:9} {:9} {:>12} {:11} {:9} {:9}\n",
                     name,
                     counts.num_closures,
                     counts.num_judged(),
                     counts.num_right,
                     counts.num_wrong,
                     share,
                     counts.num_borderline,
                     counts.num_disputed,
                     counts.num_unjudged);
}

const char* name_of(ClosureAxes axes) {
  return axes == ClosureAxes::kXY ? "xy" : axes == ClosureAxes::kX ? "x" : "y";
}

const char* name_of(ClosureTruth verdict) {
  switch (verdict) {
    case ClosureTruth::kRight:
      return "right";
    case ClosureTruth::kWrong:
      return "wrong";
    case ClosureTruth::kBorderline:
      return "borderline";
    case ClosureTruth::kDisputed:
      return "disputed";
    case ClosureTruth::kUnjudged:
      break;
  }
  return "unjudged";
}

template <typename Use>
void for_each_doubtful(std::span<const LoopClosure> closures,
                       std::span<const ClosureJudgement> judgements,
                       const Use& use) {
  for (std::size_t k = 0; k < closures.size(); ++k) {
    const ClosureTruth verdict = judgements[k].verdict;
    const bool is_doubtful = verdict != ClosureTruth::kRight && verdict != ClosureTruth::kUnjudged;
    if (closures[k].is_accepted && is_doubtful) use(closures[k], judgements[k]);
  }
}

Json json_of_counts(const ClosureCounts& counts) {
  Json json = {{"num_closures", counts.num_closures},
               {"num_judged", counts.num_judged()},
               {"num_right", counts.num_right},
               {"num_wrong", counts.num_wrong},
               {"wrong_share", nullptr},
               {"num_borderline", counts.num_borderline},
               {"num_disputed", counts.num_disputed},
               {"num_unjudged", counts.num_unjudged}};
  if (counts.num_judged() > 0) json["wrong_share"] = wrong_share(counts);
  return json;
}

Json json_of_summary(const ClosureSummary& summary) {
  return {{"accepted", json_of_counts(summary.accepted)},
          {"refused", json_of_counts(summary.refused)},
          {"num_heavy_wrong", summary.num_heavy_wrong}};
}

/// A table for people, with a sentence on what still pulls.
std::string closure_table(const ClosureSummary& summary) {
  return "closures     number    judged     right     wrong  wrong share  borderline  disputed  "
         "unjudged\n" +
         closure_row("accepted", summary.accepted) + closure_row("refused", summary.refused) +
         fmt::format("accepted, wrong and of a weight above {}: {}\n",
                     kHeavyClosure,
                     summary.num_heavy_wrong);
}

/// The accepted closures that are wrong, borderline or disputed, in order, as an array.
Json json_of_doubtful(std::span<const LoopClosure> closures,
                      std::span<const ClosureJudgement> judgements) {
  Json list = Json::array();
  for_each_doubtful(
      closures, judgements, [&list](const LoopClosure& closure, const ClosureJudgement& judgement) {
        list.push_back({{"stamp_i", to_string(closure.stamp_i)},
                        {"stamp_j", to_string(closure.stamp_j)},
                        {"verdict", name_of(judgement.verdict)},
                        {"translation_error_m", judgement.error.translation_m},
                        {"rotation_error_deg", deg_from_rad(judgement.error.rotation_rad)},
                        {"axes", name_of(closure.axes)},
                        {"weight", closure.weight},
                        {"reason", closure.reason}});
      });
  return list;
}

/// The same, one per line, tab-separated, under a header line.
std::string list_of_doubtful(std::span<const LoopClosure> closures,
                             std::span<const ClosureJudgement> judgements) {
  std::string text =
      "stamp_i\tstamp_j\tverdict\ttranslation_error_m\trotation_error_deg\taxes\tweight\treason\n";
  for_each_doubtful(
      closures, judgements, [&text](const LoopClosure& closure, const ClosureJudgement& judgement) {
        text += fmt::format("{}\t{}\t{}\t{:.3f}\t{:.3f}\t{}\t{:.3f}\t{}\n",
                            to_string(closure.stamp_i),
                            to_string(closure.stamp_j),
                            name_of(judgement.verdict),
                            judgement.error.translation_m,
                            deg_from_rad(judgement.error.rotation_rad),
                            name_of(closure.axes),
                            closure.weight,
                            closure.reason);
      });
  return text;
}

/// What a file of ground truth holds.
enum class ReferenceKind { kRelations, kTrajectory };

/// Distinguishes the two by their content, since both are eight numbers per line: a trajectory
/// (TUM) where the last four of every line are a unit quaternion, relations where those of at most
/// half the lines are. Throws FileError; FormatError where a line is not eight numbers, or where it
/// is neither.
ReferenceKind reference_kind(const std::string& path) {
  constexpr double kUnitTolerance = 1e-3;
  if (path == "-") throw Error("standard input as reference: say --reference-kind");
  std::size_t num_rows = 0;
  std::size_t num_unit = 0;
  for_each_row<1, 7>(open_file_source(path),
                     path,
                     "eight numbers: a relation, or a pose of a trajectory",
                     [&](const TableRow<1, 7>& row) {
                       const auto& [x, y, z, qx, qy, qz, qw] = row.values;
                       const double squared_norm = qx * qx + qy * qy + qz * qz + qw * qw;
                       ++num_rows;
                       if (std::abs(squared_norm - 1.0) <= kUnitTolerance) ++num_unit;
                     });
  if (num_unit == num_rows) return ReferenceKind::kTrajectory;
  if (2 * num_unit <= num_rows) return ReferenceKind::kRelations;
  throw FormatError(path, "", "neither relations nor a trajectory for sure: say --reference-kind");
}

struct ClosuresOptions {
  std::string closures_path;
  std::string reference_path;
  std::string trajectory_path;  // empty: trajectory.tum in the folder of the closures
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
    nlohmann::ordered_json json = json_of_summary(summary);
    if (options.is_list) json["doubtful"] = json_of_doubtful(closures, judgements);
    std::cout << json.dump(2) << "\n";
    return;
  }
  std::cout << closure_table(summary);
  if (options.is_list) std::cout << "\n" << list_of_doubtful(closures, judgements);
}

struct ChainsOptions {
  std::string relations_path;
  bool is_json = false;
};

/// Chains are judged by relations that close a loop in time: a file without any cannot check them.
void require_chained(const ChainCheck& check, const ChainsOptions& options) {
  const ChainCheckParams params;
  if (check.verdicts.num_closures > 0) return;
  throw FormatError(options.relations_path,
                    "",
                    fmt::format("no relation between stamps {} s and more apart: nothing to judge",
                                params.min_time_s));
}

void evaluate_chains(const ChainsOptions& options) {
  const ChainCheckParams params;
  const ChainCheck check = check_chains(read_relations(options.relations_path), params);
  require_chained(check, options);
  if (options.is_json) {
    Json json = json_of_counts(check.verdicts);
    json["translation_m"] = json_of_statistics(check.translation_m, 1.0);
    json["rotation_deg"] = json_of_statistics(check.rotation_rad, deg_from_rad(1.0));
    std::cout << json.dump(2) << "\n";
    return;
  }
  const ClosureCounts& verdicts = check.verdicts;
  std::cout << fmt::format(
                   "{} relations between stamps {} s and more apart, each judged by chains of the "
                   "others:\n{} right, {} wrong, {} borderline, {} disputed, {} out of reach; the "
                   "chains' errors:\n",
                   verdicts.num_closures,
                   params.min_time_s,
                   verdicts.num_right,
                   verdicts.num_wrong,
                   verdicts.num_borderline,
                   verdicts.num_disputed,
                   verdicts.num_unjudged)
            << statistics_table(check.translation_m, check.rotation_rad);
}

}  // namespace

void add_evaluate_closures(CLI::App& evaluate) {
  const auto options = std::make_shared<ClosuresOptions>();
  CLI::App* closures =
      evaluate.add_subcommand("closures", "How many loop closures of a map are wrong");
  closures->add_option("closures", options->closures_path, "closures.tsv of a map")
      ->type_name("")
      ->required();
  closures->add_option("reference", options->reference_path, "Relations, or the true trajectory")
      ->type_name("")
      ->required();
  closures->add_option("--trajectory", options->trajectory_path, "The map's trajectory, TUM format")
      ->type_name("FILE")
      ->default_str("trajectory.tum in the folder of the closures");
  add_choice<std::optional<ReferenceKind>, ReferenceKind>(
      *closures,
      "--reference-kind",
      options->kind,
      {{"relations", ReferenceKind::kRelations}, {"trajectory", ReferenceKind::kTrajectory}},
      "What the reference is",
      "by its content");
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

void add_evaluate_chains(CLI::App& evaluate) {
  const auto options = std::make_shared<ChainsOptions>();
  CLI::App* chains = evaluate.add_subcommand(
      "chains", "How well chains of relations predict a relation: whether to believe `closures`");
  chains->add_option("relations", options->relations_path, "Relations between poses")
      ->type_name("")
      ->required();
  chains->add_flag("--json", options->is_json, "Print JSON");
  chains->footer(
      "Errors in m and deg. \"-\" where no relation could be judged.\n"
      "Examples:\n"
      "  setsquare evaluate chains intel.relations\n"
      "  setsquare evaluate chains intel.relations --json");
  chains->callback([options] { evaluate_chains(*options); });
}

}  // namespace setsquare::app
