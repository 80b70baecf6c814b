// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/setsquare/match/one.hpp"

#include <cmath>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

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
  json["zncc_x"] = result.zncc_x;
  json["zncc_y"] = result.zncc_y;
  json["score"] = result.score;
  json["agreement"] = result.agreement;
  json["contradiction"] = result.contradiction;
  json["overlap"] = result.overlap;
  json["runner_up"] = nullptr;
  if (result.runner_up) {
    json["runner_up"] = {{"pose", json_from(result.runner_up->T_reference_current)},
                         {"score", result.runner_up->score}};
  }
  json["degenerate_direction_rad"] = nullptr;
  if (result.degenerate_direction_rad) {
    json["degenerate_direction_rad"] = *result.degenerate_direction_rad;
  }
  std::cout << json.dump(2) << "\n";
}

void print_pose(const char* label, const Pose2& pose) {
  std::printf("%-15s x %+.3f m   y %+.3f m   heading %+.2f deg\n",
              label,
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
      return "the scans do not determine the motion along one direction";
    case MatchStatus::kNoOverlap:
      return "no pose explains enough of the scans";
    case MatchStatus::kTooFewPoints:
      return "a scan has too few returns";
    case MatchStatus::kRejected:
      return "the profiles' correlation is below the paper's threshold";
  }
  return "";
}

/// The standard deviation along x, y and theta alone, the others held: no inversion of what may be
/// singular.
void print_information(const Eigen::Matrix3d& information) {
  if (!(information.diagonal().minCoeff() > 0.0)) return;
  std::printf("%-15s x %.3f m   y %.3f m   heading %.3f deg   (sigma, the others held)\n",
              "precision",
              1.0 / std::sqrt(information(0, 0)),
              1.0 / std::sqrt(information(1, 1)),
              deg_from_rad(1.0 / std::sqrt(information(2, 2))));
}

void print_text(const MatchResult& result, const Scan& reference, const Scan& current) {
  std::printf("%-15s %s\n", "reference", to_string(reference.stamp).c_str());
  std::printf("%-15s %s\n", "current", to_string(current.stamp).c_str());
  std::printf("%-15s %s: %s\n",
              "status",
              std::string(to_string(result.status)).c_str(),
              meaning(result.status));
  if (!result.T_reference_current) return;
  print_pose("pose", *result.T_reference_current);
  print_information(result.information);
  std::printf("%-15s agreement %.2f   contradiction %.3f   overlap %.2f   score %.3f\n",
              "evidence",
              result.agreement,
              result.contradiction,
              result.overlap,
              result.score);
  std::printf("%-15s along x' %.2f   along y' %.2f\n", "zncc", result.zncc_x, result.zncc_y);
  if (result.runner_up) {
    print_pose("runner-up", result.runner_up->T_reference_current);
    std::printf("%-15s %.3f below the answer\n", "", result.score - result.runner_up->score);
  }
  if (result.degenerate_direction_rad) {
    std::printf("%-15s %.1f deg in the reference's frame\n",
                "undetermined",
                deg_from_rad(*result.degenerate_direction_rad));
  }
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
