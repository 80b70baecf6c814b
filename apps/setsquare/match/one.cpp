// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/core.h>

#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "apps/setsquare/match/match.hpp"
#include "apps/setsquare/scans/select_scan.hpp"
#include "setsquare/core/angle.hpp"
#include "setsquare/matching/base_frame.hpp"

namespace setsquare::app {
namespace {

nlohmann::ordered_json json_from(const Pose2& pose) {
  return {{"x_m", pose.x_m}, {"y_m", pose.y_m}, {"theta_rad", pose.theta_rad}};
}

void print_json(const MatchResult& result, const Scan& reference, const Scan& current) {
  nlohmann::ordered_json json;
  json["reference_stamp"] = to_string(reference.stamp);
  json["current_stamp"] = to_string(current.stamp);
  json["status"] = to_string(result.status);
  json["pose"] = nullptr;
  if (result.T_reference_current) json["pose"] = json_from(*result.T_reference_current);
  auto rows = nlohmann::ordered_json::array();
  for (int row = 0; row < 3; ++row) {
    rows.push_back(
        {result.information(row, 0), result.information(row, 1), result.information(row, 2)});
  }
  json["information"] = rows;
  json["sigma"] = nullptr;
  if (const auto sigmas = marginal_sigmas(result)) {
    json["sigma"] = {{"x_m", sigmas->x_m}, {"y_m", sigmas->y_m}, {"theta_rad", sigmas->theta_rad}};
  }
  json["zncc_x"] = result.zncc_x;
  json["zncc_y"] = result.zncc_y;
  json["score"] = result.score;
  json["probability"] = result.probability;
  json["agreement"] = result.agreement;
  json["contradiction"] = result.contradiction;
  json["overlap"] = result.overlap;
  json["runner_up"] = nullptr;
  if (result.runner_up) {
    json["runner_up"] = {{"pose", json_from(result.runner_up->T_reference_current)},
                         {"score", result.runner_up->score}};
  }
  json["alias"] = nullptr;
  if (result.alias) json["alias"] = json_from(*result.alias);
  json["degenerate_direction_rad"] = nullptr;
  if (result.degenerate_direction_rad) {
    json["degenerate_direction_rad"] = *result.degenerate_direction_rad;
  }
  std::cout << json.dump(2) << "\n";
}

/// A line of the answer: what, and how much of it.
template <typename... Values>
void print_line(std::string_view label, fmt::format_string<Values...> form, Values&&... values) {
  std::cout << fmt::format("{:<15} ", label) << fmt::format(form, std::forward<Values>(values)...)
            << "\n";
}

void print_pose(std::string_view label, const Pose2& pose) {
  print_line(label,
             "x {:+.3f} m   y {:+.3f} m   heading {:+.2f} deg",
             pose.x_m,
             pose.y_m,
             deg_from_rad(pose.theta_rad));
}

const char* meaning(MatchStatus status) {
  switch (status) {
    case MatchStatus::kMatched:
      return "the pose is determined by the scans and stands alone";
    case MatchStatus::kAmbiguous:
      return "another pose explains the scans almost as well, or too little speaks for this one";
    case MatchStatus::kDegenerate:
      return "the scans leave the motion along one direction open, or the rotation";
    case MatchStatus::kNoOverlap:
      return "no pose explains enough of the scans";
    case MatchStatus::kTooFewPoints:
      return "a scan has too few returns";
    case MatchStatus::kRejected:
      return "the profiles' correlation is below the paper's threshold";
  }
  return "";
}

/// The marginal standard deviations, or what the scans leave open.
void print_precision(const MatchResult& result) {
  if (const auto sigmas = marginal_sigmas(result)) {
    print_line("precision",
               "x {:.3f} m   y {:.3f} m   heading {:.3f} deg   (standard deviations)",
               sigmas->x_m,
               sigmas->y_m,
               deg_from_rad(sigmas->theta_rad));
  }
  if (result.degenerate_direction_rad) {
    print_line("precision",
               "open along {:.1f} deg in the reference's frame",
               deg_from_rad(*result.degenerate_direction_rad));
  } else if (result.status == MatchStatus::kDegenerate) {
    print_line("precision", "open in rotation");
  }
}

void print_text(const MatchResult& result, const Scan& reference, const Scan& current) {
  print_line("reference", "{}", to_string(reference.stamp));
  print_line("current", "{}", to_string(current.stamp));
  print_line("status", "{}: {}", to_string(result.status), meaning(result.status));
  if (!result.T_reference_current) return;
  print_pose("pose", *result.T_reference_current);
  print_precision(result);
  if (!std::isnan(result.agreement)) {  // the paper's preset does not measure it
    print_line("evidence",
               "agreement {:.2f}   contradiction {:.3f}   overlap {:.2f}",
               result.agreement,
               result.contradiction,
               result.overlap);
  }
  print_line("score", "{:.3f}", result.score);
  if (!std::isnan(result.probability)) print_line("probability", "{:.5f}", result.probability);
  if (result.alias) print_pose("looks the same", *result.alias);
  print_line("zncc", "along x' {:.2f}   along y' {:.2f}", result.zncc_x, result.zncc_y);
  if (!result.runner_up) return;
  print_pose("runner-up", result.runner_up->T_reference_current);
  print_line("", "{:.3f} below the answer", result.score - result.runner_up->score);
}

}  // namespace

void match_one(const MatchOneOptions& options) {
  const auto selected = select_scans(options.log_path, options.scans, options.log);
  const Scan& reference = selected[0].scan;
  const Scan& current = selected[1].scan;
  MatchResult result = match_by(options.preset, reference, current);
  if (!options.is_of_sensor) {
    result = match_result_of_base(result, reference.T_base_sensor, current.T_base_sensor);
  }
  if (options.is_json) {
    print_json(result, reference, current);
  } else {
    print_text(result, reference, current);
  }
}

}  // namespace setsquare::app
