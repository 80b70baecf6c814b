// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <CLI/Option.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/setsquare/command_line/options.hpp"
#include "apps/setsquare/evaluate/evaluate.hpp"
#include "apps/setsquare/evaluate/results.hpp"
#include "apps/setsquare/evaluate/statistics.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/eval/absolute_trajectory_error.hpp"
#include "setsquare/eval/relative_trajectory_error.hpp"
#include "setsquare/io/tables/trajectory_kitti.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"
#include "setsquare/report/error_plots.hpp"

namespace setsquare::app {
namespace {

using Json = nlohmann::ordered_json;

struct TrajectoryFiles {
  std::string trajectory_path;
  std::string reference_path;
  double max_time_difference_s = 0.0;
  QuaternionOrder order_of_reference = QuaternionOrder::kWLast;
  bool is_json = false;
  ResultOptions results;
};

struct AteOptions {
  TrajectoryFiles files;
  TrajectoryAlignment alignment = TrajectoryAlignment::kBest;
};

struct RpeOptions {
  TrajectoryFiles files;
  double delta_m = 1.0;
  double delta_s = 0.0;      // 0: not asked for
  double delta_poses = 0.0;  // 0: not asked for
};

/// Reads a trajectory; tells on standard error where most of its poses lie on their side.
Trajectory read_told(const std::string& path, QuaternionOrder order = QuaternionOrder::kWLast) {
  TumReading reading = read_tum(path, order);
  const std::size_t num_poses = reading.trajectory.size();
  if (2 * reading.num_tilted > num_poses) {
    std::cerr << fmt::format(
        "setsquare: {}: {} of {} poses lie on their side (tilted by more than 45 deg): are the "
        "quaternions written w first? Read were qx qy qz qw; try --w-first for the reference\n",
        path,
        reading.num_tilted,
        num_poses);
  }
  return std::move(reading.trajectory);
}

PairedPoses read_pairs(const TrajectoryFiles& files) {
  const Trajectory trajectory = read_told(files.trajectory_path);
  const Trajectory reference = read_told(files.reference_path, files.order_of_reference);
  PairedPoses paired = pair_poses(trajectory, reference, files.max_time_difference_s);
  if (paired.pairs.empty()) {
    throw FormatError(
        files.reference_path,
        "",
        "no pose at the time of one in " + files.trajectory_path + " (see --max-time-difference)");
  }
  return paired;
}

Json json_of_pairs(const PairedPoses& paired) {
  return {{"num_pairs", paired.pairs.size()}, {"num_unpaired", paired.num_unpaired}};
}

void add_errors(Json& json, const ErrorStatistics& translation_m, const ErrorStatistics& rotation) {
  json["translation_m"] = json_of_statistics(translation_m, 1.0);
  json["rotation_deg"] = json_of_statistics(rotation, deg_from_rad(1.0));
}

void print_pairs(const PairedPoses& paired) {
  std::cout << paired.pairs.size() << " poses paired with the reference";
  if (paired.num_unpaired > 0) std::cout << ", " << paired.num_unpaired << " without one there";
  std::cout << "\n";
}

/// The tables and plots of errors one by one, under names that begin alike; the JSON is last.
std::vector<ResultFile> files_of(const std::string& name,
                                 const ErrorSeries& errors,
                                 const ErrorStatistics& translation_m,
                                 const ErrorStatistics& rotation_rad,
                                 const Json& json) {
  return {{name + ".tsv", statistics_tsv(translation_m, rotation_rad)},
          {name + "_errors.tsv", tsv_of(errors)},
          {name + "_errors.svg",
           error_plot_svg({errors.stamps, errors.translation_m, errors.rotation_rad})},
          {name + ".json", json.dump(2) + "\n"}};
}

InputPaths inputs_of(const TrajectoryFiles& files) {
  return {files.trajectory_path, files.reference_path};
}

std::ostream* told_on(const TrajectoryFiles& files) { return files.is_json ? nullptr : &std::cout; }

/// Both trajectories at the moments of the pairs, in the reference's frame: what other programs
/// compare, TUM by stamps and KITTI line by line.
std::vector<ResultFile> paired_trajectories(const PairedPoses& paired, const Pose2& T_truth_map) {
  Trajectory aligned;
  Trajectory reference;
  for (const PosePair& pair : paired.pairs) {
    aligned.push_back({pair.stamp, T_truth_map * pair.T_map_base});
    reference.push_back({pair.stamp, pair.T_truth_base});
  }
  return {{"aligned.tum", tum_from_trajectory(aligned)},
          {"reference.tum", tum_from_trajectory(reference)},
          {"aligned.kitti", kitti_from_trajectory(aligned)},
          {"reference.kitti", kitti_from_trajectory(reference)},
          {"ate_trajectories.svg", trajectory_plot_svg(aligned, reference)}};
}

Json json_of(const PairedPoses& paired, const AbsoluteTrajectoryError& error) {
  Json json = json_of_pairs(paired);
  json["alignment"] = {{"x_m", error.T_truth_map.x_m},
                       {"y_m", error.T_truth_map.y_m},
                       {"theta_deg", deg_from_rad(error.T_truth_map.theta_rad)}};
  add_errors(json, error.translation_m, error.rotation_rad);
  json["final"] = {{"translation_m", error.final_translation_m},
                   {"rotation_deg", deg_from_rad(error.final_rotation_rad)}};
  return json;
}

void print_ate(const PairedPoses& paired, const AbsoluteTrajectoryError& error) {
  const Pose2& alignment = error.T_truth_map;
  print_pairs(paired);
  std::cout << fmt::format("aligned by x {:+.3f} m, y {:+.3f} m, heading {:+.3f} deg\n",
                           alignment.x_m,
                           alignment.y_m,
                           deg_from_rad(alignment.theta_rad))
            << statistics_table(error.translation_m, error.rotation_rad)
            << fmt::format("final pose: {:.4f} m, {:.4f} deg off\n",
                           error.final_translation_m,
                           deg_from_rad(error.final_rotation_rad));
}

void evaluate_ate(const AteOptions& options) {
  const TrajectoryFiles& files = options.files;
  const PairedPoses paired = read_pairs(files);
  const auto error =
      absolute_trajectory_error(paired.pairs, options.alignment, files.results.bootstrap());
  const Json json = json_of(paired, error);
  if (files.is_json) {
    std::cout << json.dump(2) << "\n";
  } else {
    print_ate(paired, error);
  }
  if (files.results.directory.empty()) return;
  std::vector<ResultFile> written = paired_trajectories(paired, error.T_truth_map);
  for (ResultFile& file : files_of("ate",
                                   absolute_errors(paired.pairs, error.T_truth_map),
                                   error.translation_m,
                                   error.rotation_rad,
                                   json)) {
    written.push_back(std::move(file));
  }
  write_results(files.results, written, inputs_of(files), told_on(files));
}

RelativeErrorParams span_of(const RpeOptions& options) {
  if (options.delta_s > 0.0) return {RelativeSpan::kTime, options.delta_s};
  if (options.delta_poses > 0.0) return {RelativeSpan::kPoses, options.delta_poses};
  return {RelativeSpan::kDistance, options.delta_m};
}

void evaluate_rpe(const RpeOptions& options) {
  const TrajectoryFiles& files = options.files;
  const PairedPoses paired = read_pairs(files);
  const auto error =
      relative_trajectory_error(paired.pairs, span_of(options), files.results.bootstrap());
  const std::size_t num_spans = error.translation_m.num_values;
  if (num_spans == 0) {
    throw FormatError(
        files.reference_path,
        "",
        "no two paired poses are as far apart as --delta-m, --delta-s or --delta-poses asks");
  }
  Json json = json_of_pairs(paired);
  json["num_spans"] = num_spans;
  json["num_left_out"] = error.num_left_out;
  add_errors(json, error.translation_m, error.rotation_rad);
  if (files.is_json) {
    std::cout << json.dump(2) << "\n";
  } else {
    print_pairs(paired);
    std::cout << num_spans << " spans";
    if (error.num_left_out > 0) {
      std::cout << ", " << error.num_left_out << " left out: a gap in them";
    }
    std::cout << "\n" << statistics_table(error.translation_m, error.rotation_rad);
  }
  if (files.results.directory.empty()) return;
  const RelativeErrors found = relative_errors(paired.pairs, span_of(options));
  write_results(files.results,
                files_of("rpe", found.errors, error.translation_m, error.rotation_rad, json),
                inputs_of(files),
                told_on(files));
}

void add_files(CLI::App& subcommand, TrajectoryFiles& files) {
  subcommand.add_option("trajectory", files.trajectory_path, "Trajectory, TUM format")
      ->type_name("")
      ->required();
  subcommand.add_option("reference", files.reference_path, "The true one, TUM format")
      ->type_name("")
      ->required();
  add_time_difference_option(subcommand, files.max_time_difference_s);
  subcommand.add_flag_callback(
      "--w-first",
      [&files] { files.order_of_reference = QuaternionOrder::kWFirst; },
      "The reference's quaternions are written qw qx qy qz");
  subcommand.add_flag("--json", files.is_json, "Print JSON");
  add_result_options(subcommand, files.results);
}

}  // namespace

void add_evaluate_ate(CLI::App& evaluate) {
  const auto options = std::make_shared<AteOptions>();
  CLI::App* ate =
      evaluate.add_subcommand("ate", "Absolute error of a trajectory against a true trajectory");
  add_files(*ate, options->files);
  add_choice<TrajectoryAlignment, TrajectoryAlignment>(
      *ate,
      "--align",
      options->alignment,
      {{"best", TrajectoryAlignment::kBest},
       {"first", TrajectoryAlignment::kFirst},
       {"none", TrajectoryAlignment::kNone}},
      "Before comparing: the rigid motion of least squares, the first pose onto the true one, or "
      "none",
      "best");
  ate->footer(
      "Errors in m and deg. The order of either file does not matter. The deviation is that of "
      "the\n"
      "set (n). -o writes ate.json, ate.tsv (the table with its bounds), ate_errors.tsv and .svg\n"
      "(each error, over time), ate_trajectories.svg, and both trajectories, paired and aligned, "
      "for\n"
      "evo and others: aligned.tum and reference.tum, aligned.kitti and reference.kitti.\n"
      "Neighbouring errors are alike: bounds come of blocks of them, drawn again and again.\n"
      "Examples:\n"
      "  setsquare evaluate ate out/trajectory.tum sim/truth.tum\n"
      "  setsquare evaluate ate out/trajectory.tum sim/truth.tum --align first --json\n"
      "  setsquare evaluate ate out/trajectory.tum sim/truth.tum -o evaluation");
  ate->callback([options] { evaluate_ate(*options); });
}

void add_evaluate_rpe(CLI::App& evaluate) {
  const auto options = std::make_shared<RpeOptions>();
  CLI::App* rpe =
      evaluate.add_subcommand("rpe", "Relative error of a trajectory against a true trajectory");
  add_files(*rpe, options->files);
  CLI::Option* metres =
      rpe->add_option("--delta-m", options->delta_m, "Over this length of the true path")
          ->check(number_from(1e-3, 1e9))
          ->type_name("M");
  CLI::Option* seconds = rpe->add_option("--delta-s", options->delta_s, "Instead: over this time")
                             ->check(number_from(1e-3, 1e9))
                             ->excludes(metres)
                             ->default_str("")
                             ->type_name("S");
  rpe->add_option("--delta-poses", options->delta_poses, "Instead: over this number of poses")
      ->check(number_from(1.0, 1e9))
      ->excludes(metres)
      ->excludes(seconds)
      ->default_str("")
      ->type_name("N");
  rpe->footer(
      "Errors in m and deg, from each pose to the first one that is at least so far on. Poses are\n"
      "taken in the order of their stamps, whatever that of the files. -o writes rpe.json, "
      "rpe.tsv,\n"
      "rpe_errors.tsv and rpe_errors.svg.\n"
      "Examples:\n"
      "  setsquare evaluate rpe out/trajectory.tum sim/truth.tum --delta-m 10\n"
      "  setsquare evaluate rpe out/trajectory.tum sim/truth.tum --delta-s 1");
  rpe->callback([options] { evaluate_rpe(*options); });
}

}  // namespace setsquare::app
