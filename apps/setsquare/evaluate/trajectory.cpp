// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/Option.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "apps/setsquare/command_line/options.hpp"
#include "apps/setsquare/evaluate/evaluate.hpp"
#include "apps/setsquare/evaluate/statistics.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/core/error.hpp"
#include "setsquare/eval/absolute_trajectory_error.hpp"
#include "setsquare/eval/relative_trajectory_error.hpp"
#include "setsquare/io/tables/trajectory_tum.hpp"

namespace setsquare::app {
namespace {

using Json = nlohmann::ordered_json;

struct TrajectoryFiles {
  std::string trajectory_path;
  std::string reference_path;
  double max_time_difference_s = 0.0;
  QuaternionOrder order_of_reference = QuaternionOrder::kWLast;
  bool is_json = false;
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

void evaluate_ate(const AteOptions& options) {
  const PairedPoses paired = read_pairs(options.files);
  const auto error = absolute_trajectory_error(paired.pairs, options.alignment);
  const Pose2& alignment = error.T_truth_map;
  if (options.files.is_json) {
    Json json = json_of_pairs(paired);
    json["alignment"] = {{"x_m", alignment.x_m},
                         {"y_m", alignment.y_m},
                         {"theta_deg", deg_from_rad(alignment.theta_rad)}};
    add_errors(json, error.translation_m, error.rotation_rad);
    json["final"] = {{"translation_m", error.final_translation_m},
                     {"rotation_deg", deg_from_rad(error.final_rotation_rad)}};
    std::cout << json.dump(2) << "\n";
    return;
  }
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

RelativeErrorParams span_of(const RpeOptions& options) {
  if (options.delta_s > 0.0) return {RelativeSpan::kTime, options.delta_s};
  if (options.delta_poses > 0.0) return {RelativeSpan::kPoses, options.delta_poses};
  return {RelativeSpan::kDistance, options.delta_m};
}

void evaluate_rpe(const RpeOptions& options) {
  const PairedPoses paired = read_pairs(options.files);
  const auto error = relative_trajectory_error(paired.pairs, span_of(options));
  const std::size_t num_spans = error.translation_m.num_values;
  if (num_spans == 0) {
    throw FormatError(
        options.files.reference_path,
        "",
        "no two paired poses are as far apart as --delta-m, --delta-s or --delta-poses asks");
  }
  if (options.files.is_json) {
    Json json = json_of_pairs(paired);
    json["num_spans"] = num_spans;
    json["num_left_out"] = error.num_left_out;
    add_errors(json, error.translation_m, error.rotation_rad);
    std::cout << json.dump(2) << "\n";
    return;
  }
  print_pairs(paired);
  std::cout << num_spans << " spans";
  if (error.num_left_out > 0) std::cout << ", " << error.num_left_out << " left out: a gap in them";
  std::cout << "\n" << statistics_table(error.translation_m, error.rotation_rad);
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
      "set (n).\n"
      "Examples:\n"
      "  setsquare evaluate ate out/trajectory.tum sim/truth.tum\n"
      "  setsquare evaluate ate out/trajectory.tum sim/truth.tum --align first --json");
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
      "taken in the order of their stamps, whatever that of the files.\n"
      "Examples:\n"
      "  setsquare evaluate rpe out/trajectory.tum sim/truth.tum --delta-m 10\n"
      "  setsquare evaluate rpe out/trajectory.tum sim/truth.tum --delta-s 1");
  rpe->callback([options] { evaluate_rpe(*options); });
}

}  // namespace setsquare::app
