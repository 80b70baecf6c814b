// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/circuit_study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/chain_map.hpp"
#include "experiments/mapper_chain.hpp"
#include "experiments/simulated_run.hpp"
#include "experiments/tally.hpp"

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
/// travelled, which rounded corners shorten by a few metres, tells which time is meant.
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

}  // namespace setsquare::experiments
