// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/circuit_report.hpp"
#include "experiments/tally.hpp"

namespace setsquare::experiments {
namespace {

Json json_from(const ChainCounts& counts) {
  return {{"matched", counts.num_matched},
          {"degenerate", counts.num_degenerate},
          {"ambiguous", counts.num_ambiguous},
          {"unmatched", counts.num_unmatched}};
}

Json json_from(const HeadingErrors& errors) {
  const double to_deg = deg_from_rad(1.0);
  return {{"max_deg", to_deg * errors.highest_rad},
          {"mean_deg", to_deg * errors.mean_rad},
          {"end_deg", to_deg * errors.end_rad},
          {"slope_deg_per_100_m", to_deg * errors.slope_rad_per_100_m},
          {"num_wrong_turns", errors.num_wrong_turns},
          {"modulo_90_deg",
           {{"mean_deg", to_deg * errors.square_mean_rad},
            {"end_deg", to_deg * errors.square_end_rad},
            {"slope_deg_per_100_m", to_deg * errors.square_slope_rad_per_100_m}}}};
}

Json json_from(const ChainOutcome& outcome) {
  Json closures = Json::array();
  for (const Eigen::Vector2d& error_m : outcome.closure_m) {
    closures.push_back({{"x_m", error_m.x()}, {"y_m", error_m.y()}, {"norm_m", error_m.norm()}});
  }
  return {{"closures", closures},
          {"heading", json_from(outcome.heading)},
          {"scans", json_from(outcome.chain.counts)}};
}

Json json_from(const ChainOutcome& outcome, const MapErrors& errors) {
  Json json = json_from(outcome);
  json["first_pose_aligned"] = {{"final_m", errors.first_final_m}, {"mean_m", errors.first_mean_m}};
  json["best_aligned"] = {{"mean_m", errors.mean_m},
                          {"max_m", errors.highest_m},
                          {"heading_mean_deg", deg_from_rad(errors.heading_mean_rad)},
                          {"heading_max_deg", deg_from_rad(errors.heading_highest_rad)}};
  json["num_pieces"] = errors.num_pieces;
  json["num_unjoined"] = errors.num_unjoined;
  json["loop_closures"] = {{"accepted", errors.closures.num_accepted},
                           {"wrong", errors.closures.num_wrong},
                           {"wrong_of_weight_above_0_3", errors.closures.num_wrong_heavy}};
  return json;
}

Json json_from(const ClosureMedians& medians) {
  return {{"abs_x_m", medians.x_m}, {"abs_y_m", medians.y_m}, {"norm_m", medians.norm_m}};
}

Json json_from(const MapMedians& medians) {
  return {{"final_m", medians.final_m},
          {"worst_final_m", medians.worst_final_m},
          {"mean_m", medians.mean_m},
          {"worst_mean_m", medians.worst_mean_m}};
}

Json json_from(const CircuitRun& run) {
  Json circuits = Json::array();
  for (const CircuitScans& circuit : run.circuits) {
    circuits.push_back({{"order", circuit.order},
                        {"first_scan", circuit.start},
                        {"last_scan", circuit.end},
                        {"length_m", circuit.length_m}});
  }
  return {{"seed", run.seed},
          {"num_scans", run.truth.size()},
          {"track_m", travelled_m(run.truth).back()},
          {"circuits", circuits},
          {"paper", json_from(run.paper)},
          {"paper_literal", json_from(run.paper_literal)},
          {"default", json_from(run.ours)},
          {"full_mapper", json_from(run.mapper, run.mapper_errors)},
          {"full_mapper_with_odometry", json_from(run.wheeled, run.wheeled_errors)}};
}

}  // namespace

Json json_from(const CircuitStudy& study) {
  Json runs = Json::array();
  for (const CircuitRun& run : study.runs) runs.push_back(json_from(run));
  return {
      {"stated_by_the_paper",
       {{"after_398_m", {{"x_m", 0.3}, {"y_m", 0.8}}},
        {"after_901_m", {{"x_m", 0.5}, {"y_m", 1.2}}}}},
      {"median_closure_errors",
       {{"paper", json_from(closure_medians(study, &CircuitRun::paper))},
        {"paper_literal", json_from(closure_medians(study, &CircuitRun::paper_literal))},
        {"default", json_from(closure_medians(study, &CircuitRun::ours))},
        {"full_mapper", json_from(closure_medians(study, &CircuitRun::mapper))},
        {"full_mapper_with_odometry", json_from(closure_medians(study, &CircuitRun::wheeled))}}},
      {"median_map_errors",
       {{"full_mapper", json_from(map_medians(study, &CircuitRun::mapper_errors))},
        {"full_mapper_with_odometry", json_from(map_medians(study, &CircuitRun::wheeled_errors))}}},
      {"runs", runs}};
}

}  // namespace setsquare::experiments
