// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/circuit_study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "experiments/simulated_run.hpp"
#include "experiments/tally.hpp"
#include "setsquare/drawing/png.hpp"
#include "setsquare/grid/grid_from_scans.hpp"
#include "setsquare/report/map/picture.hpp"

namespace setsquare::experiments {
namespace {

Eigen::Vector2d point_at(const std::vector<Eigen::Vector2d>& route_m, double s_m) {
  for (std::size_t i = 1; i < route_m.size(); ++i) {
    const Eigen::Vector2d piece = route_m[i] - route_m[i - 1];
    if (s_m <= piece.norm()) return route_m[i - 1] + piece * (s_m / piece.norm());
    s_m -= piece.norm();
  }
  return route_m.back();
}

/// The scan nearest to a place of the route. The track passes places several times: the distance
/// travelled, which rounded corners shorten by a few metres, decides which time is meant.
std::size_t scan_at(const std::vector<Pose2>& truth,
                    const std::vector<double>& path_m,
                    const std::vector<Eigen::Vector2d>& route_m,
                    double s_m) {
  const Eigen::Vector2d place = point_at(route_m, s_m);
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const double distance_m =
        (truth[k].translation() - place).norm() + 0.05 * std::abs(path_m[k] - s_m);
    if (distance_m < least) {
      least = distance_m;
      nearest = k;
    }
  }
  return nearest;
}

ChainOutcome judge_chain(ScanChain chain, const CircuitRun& run, double axis_rad) {
  ChainOutcome outcome;
  outcome.chain = std::move(chain);
  outcome.chain.T_map_base = placed_at_truth(outcome.chain.T_map_base, run.truth, axis_rad);
  for (std::size_t c = 0; c < run.circuits.size(); ++c) {
    outcome.closure_m[c] = closure_error(
        outcome.chain.T_map_base, run.truth, run.circuits[c].start, run.circuits[c].end);
  }
  outcome.heading = heading_errors(outcome.chain.T_map_base, run.truth);
  return outcome;
}

/// The scans laid out at these poses (one per scan) as an occupancy grid with the track in it; a
/// PNG file's bytes. Its rows run along `axis_rad` of the map frame.
std::string map_png(std::span<const SimulatedScan> scans,
                    std::span<const Pose2> T_map_base,
                    double axis_rad) {
  std::vector<PlacedScan> placed;
  Trajectory trajectory;
  for (std::size_t k = 0; k < scans.size(); ++k) {
    placed.push_back({&scans[k].scan, T_map_base[k] * scans[k].scan.T_base_sensor});
    trajectory.push_back({scans[k].scan.stamp, T_map_base[k]});
  }
  // Enough for a picture a screen wide.
  const GridFromScansParams grid{.resolution_m = 0.1, .min_spacing_m = 0.7, .min_turn_rad = 0.5};
  const MapPictureParams picture{.max_side_px = 1300};
  return png_from_image(map_picture(grid_from_scans(placed, axis_rad, grid), trajectory, picture));
}

SimulatedRun simulate_track(const CircuitStudyParams& params,
                            const PaperBuilding& world,
                            std::uint64_t seed) {
  const RobotPath path(world.building.route_m);
  std::vector<double> times_s = sample_times(path, params.spacing_m, params.spacing_rad);
  times_s.resize(std::min(times_s.size(), params.max_num_scans));
  return simulate_run(world.building, path, times_s, {}, sub_seed(seed, 1));
}

void find_circuits(CircuitRun& run, const PaperBuilding& world) {
  const std::vector<double> path_m = travelled_m(run.truth);
  for (std::size_t c = 0; c < run.circuits.size(); ++c) {
    const Circuit& circuit = world.circuits[c];
    const auto at = [&](double s_m) {
      return scan_at(run.truth, path_m, world.building.route_m, s_m);
    };
    const std::size_t start = at(circuit.start_s_m);
    const std::size_t end = at(circuit.end_s_m);
    run.circuits[c] = {std::string(circuit.order), start, end, path_m[end] - path_m[start]};
  }
}

void map_in_full(const SimulatedRun& simulated, double axis_rad, CircuitRun& run) {
  const Map track = track_by_mapper(simulated.scans);
  run.mapper = judge_chain(chain_from(track), run, axis_rad);
  run.mapper_errors = map_errors(track, run.truth);
  const Map wheeled = track_by_mapper(simulated.scans, sub_seed(run.seed, 2));
  run.wheeled = judge_chain(chain_from(wheeled), run, axis_rad);
  run.wheeled_errors = map_errors(wheeled, run.truth);
}

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

CircuitStudy study_circuits(const CircuitStudyParams& params,
                            std::size_t num_threads,
                            const Progress& progress) {
  CircuitStudy study;
  study.runs.resize(params.num_seeds);
  const auto study_one = [&](std::size_t task) {
    CircuitRun& run = study.runs[task];
    run.seed = task + 1;
    const PaperBuilding world = make_paper_building(run.seed);
    const SimulatedRun simulated = simulate_track(params, world, run.seed);
    for (const SimulatedScan& scan : simulated.scans) run.truth.push_back(scan.T_map_base);
    find_circuits(run, world);
    const double axis_rad = axis_of_plan(world.building.plan);
    PaperChains paper = chains_by_paper(simulated.scans);
    run.paper = judge_chain(std::move(paper.in_sequence), run, axis_rad);
    run.paper_literal = judge_chain(std::move(paper.literal), run, axis_rad);
    run.ours = judge_chain(chain_by_default_matcher(simulated.scans), run, axis_rad);
    map_in_full(simulated, axis_rad, run);
    if (task > 0) return;
    study.plan = world.building.plan;
    study.paper_map = map_png(simulated.scans, run.paper.chain.T_map_base, axis_rad);
    study.default_map = map_png(simulated.scans, run.ours.chain.T_map_base, axis_rad);
    study.mapper_map = map_png(simulated.scans, run.mapper.chain.T_map_base, axis_rad);
  };
  run_in_parallel(params.num_seeds, num_threads, study_one, progress);
  return study;
}

ClosureMedians closure_medians(const CircuitStudy& study, ChainOutcome CircuitRun::*outcome) {
  ClosureMedians medians;
  for (std::size_t c = 0; c < medians.norm_m.size(); ++c) {
    std::vector<double> x_m, y_m, norm_m;
    for (const CircuitRun& run : study.runs) {
      const Eigen::Vector2d& error_m = (run.*outcome).closure_m[c];
      x_m.push_back(std::abs(error_m.x()));
      y_m.push_back(std::abs(error_m.y()));
      norm_m.push_back(error_m.norm());
    }
    medians.x_m[c] = median(x_m);
    medians.y_m[c] = median(y_m);
    medians.norm_m[c] = median(norm_m);
  }
  return medians;
}

MapMedians map_medians(const CircuitStudy& study, MapErrors CircuitRun::*errors) {
  std::vector<double> final_m, mean_m;
  for (const CircuitRun& run : study.runs) {
    final_m.push_back((run.*errors).first_final_m);
    mean_m.push_back((run.*errors).first_mean_m);
  }
  return {median(final_m),
          *std::max_element(final_m.begin(), final_m.end()),
          median(mean_m),
          *std::max_element(mean_m.begin(), mean_m.end())};
}

HeadingJudgement judge_headings(const CircuitStudy& study, ChainOutcome CircuitRun::*outcome) {
  HeadingJudgement judgement;
  std::vector<double> ends_deg, slopes_deg;
  for (const CircuitRun& run : study.runs) {
    const HeadingErrors& heading = (run.*outcome).heading;
    ends_deg.push_back(deg_from_rad(heading.end_rad));
    slopes_deg.push_back(std::abs(deg_from_rad(heading.slope_rad_per_100_m)));
    judgement.num_wrong_turns += heading.num_wrong_turns;
    judgement.worst_end_deg = std::max(judgement.worst_end_deg, ends_deg.back());
    if (ends_deg.back() > kMaxEndHeading_deg) judgement.failing.push_back(&run);
  }
  judgement.median_end_deg = median(ends_deg);
  judgement.median_slope_deg_per_100_m = median(slopes_deg);
  return judgement;
}

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
