// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/hallway_study.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

#include "experiments/building_study.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/paper/paper_matcher.hpp"

namespace setsquare::experiments {
namespace {

SimulatedRun simulate_hallway(const HallwayStudyParams& params, std::uint64_t seed) {
  const Building hallway = make_paper_hallway(seed);
  const RobotPath path(hallway.route_m);
  std::vector<double> times_s = sample_times(path, params.spacing_m, params.spacing_rad);
  times_s.resize(std::min(times_s.size(), params.num_scans));
  return simulate_run(hallway, path, times_s, {}, sub_seed(seed, 1));
}

PairAnswer judge_peer(const std::optional<Pose2>& answered, const Pose2& truth) {
  PairAnswer answer{.status = answered ? MatchStatus::kMatched : MatchStatus::kNoOverlap};
  if (answered) answer.error = pose_error(*answered, truth);
  return answer;
}

HallwayRun study_hallway(const HallwayStudyParams& params,
                         const PeerMatcher& icp,
                         std::uint64_t seed) {
  const SimulatedRun run = simulate_hallway(params, seed);
  HallwayRun result{seed, {}, run.caster.plan(), {}};
  for (const SimulatedScan& simulated : run.scans) {
    result.T_map_base.push_back(simulated.T_map_base);
  }
  const PairParams pairs{.max_distance_m = std::numeric_limits<double>::infinity()};
  for (const PairRecord& record : match_pairs(run, pairs)) {
    HallwayPair pair{record, {}};
    if (icp) {
      pair.icp = judge_peer(
          icp(run.scans[record.truth.reference].scan, run.scans[record.truth.current].scan),
          record.truth.T_reference_current);
    }
    result.pairs.push_back(pair);
  }
  return result;
}

template <typename Match>
double median_ms(const SimulatedRun& run, const Match& match_scans) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> times_ms;
  for (std::size_t i = 0; i < run.scans.size(); ++i) {
    for (std::size_t j = i + 1; j < run.scans.size(); ++j) {
      const auto start = Clock::now();
      match_scans(run.scans[i].scan, run.scans[j].scan);
      times_ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    }
  }
  return median(times_ms);
}

MatchTimes measure_times(const HallwayStudyParams& params, const PeerMatcher& icp) {
  const SimulatedRun run = simulate_hallway(params, 1);
  MatchTimes times{.icp_ms = std::numeric_limits<double>::quiet_NaN()};
  using Scans = const Scan&;
  if (icp) times.icp_ms = median_ms(run, [&](Scans a, Scans b) { static_cast<void>(icp(a, b)); });
  times.paper_ms = median_ms(run, [](Scans a, Scans b) { static_cast<void>(match_paper(a, b)); });
  times.ours_ms = median_ms(run, [](Scans a, Scans b) { static_cast<void>(match(a, b)); });
  return times;
}

Json json_from(const HallwaySummary& summary, bool has_icp) {
  Json json = {{"num_overlap_45_and_more_undetermined", summary.num_high_undetermined}};
  if (has_icp) {
    json["mrpt_icp"] = {
        {"all_pairs", experiments::json_from(summary.icp)},
        {"determined_overlap_45_and_more", experiments::json_from(summary.icp_high)}};
  } else {
    json["mrpt_icp"] = "MRPT is not installed";
  }
  json["paper"] = {{"all_pairs", experiments::json_from(summary.paper)},
                   {"determined_overlap_45_and_more", experiments::json_from(summary.paper_high)}};
  json["default"] = {{"all_pairs", experiments::json_from(summary.ours)},
                     {"determined_overlap_45_and_more", experiments::json_from(summary.ours_high)}};
  return json;
}

Json pairs_json(const HallwayRun& run, bool has_icp) {
  Json pairs = Json::array();
  for (const HallwayPair& pair : run.pairs) {
    const PairTruth& truth = pair.record.truth;
    Json entry = {{"reference", truth.reference},
                  {"current", truth.current},
                  {"overlap", truth.overlap},
                  {"is_determined", truth.is_determined}};
    if (has_icp) entry["mrpt_icp"] = experiments::json_from(pair.icp);
    entry["paper"] = experiments::json_from(pair.record.paper);
    entry["default"] = experiments::json_from(pair.record.ours);
    pairs.push_back(std::move(entry));
  }
  return pairs;
}

}  // namespace

HallwayStudy study_hallways(const HallwayStudyParams& params,
                            const PeerMatcher& icp,
                            std::size_t num_threads,
                            const Progress& progress) {
  HallwayStudy study;
  study.has_icp = static_cast<bool>(icp);
  study.runs.resize(params.num_seeds);
  const auto study_one = [&](std::size_t task) {
    study.runs[task] = study_hallway(params, icp, task + 1);
  };
  run_in_parallel(params.num_seeds, num_threads, study_one, progress);
  study.times = measure_times(params, icp);
  return study;
}

HallwaySummary summarise(const HallwayStudy& study, std::size_t num_runs) {
  HallwaySummary summary;
  for (std::size_t r = 0; r < std::min(num_runs, study.runs.size()); ++r) {
    for (const HallwayPair& pair : study.runs[r].pairs) {
      const PairTruth& truth = pair.record.truth;
      summary.paper.add(pair.record.paper);
      summary.ours.add(pair.record.ours);
      if (study.has_icp) summary.icp.add(pair.icp);
      if (truth.overlap < kHighOverlap) continue;
      summary.num_high_undetermined += !truth.is_determined;
      if (!truth.is_determined) continue;
      summary.paper_high.add(pair.record.paper);
      summary.ours_high.add(pair.record.ours);
      if (study.has_icp) summary.icp_high.add(pair.icp);
    }
  }
  return summary;
}

Json json_from(const HallwayStudy& study) {
  return {{"stated_by_the_paper",
           {{"overlap_above_which_it_succeeds", 0.45},
            {"error_m", {{"mean", 0.04}, {"sigma", 0.02}}},
            {"error_deg", {{"mean", 0.33}, {"sigma", 0.25}}},
            {"icp_error_m", {{"mean", 0.07}, {"sigma", 0.03}}},
            {"icp_error_deg", {{"mean", 0.51}, {"sigma", 0.32}}},
            {"match_ms", 17},
            {"icp_match_ms", 11}}},
          {"num_hallways", study.runs.size()},
          {"first_hallway", json_from(summarise(study, 1), study.has_icp)},
          {"all_hallways", json_from(summarise(study, study.runs.size()), study.has_icp)},
          {"pairs_of_the_first", pairs_json(study.runs.front(), study.has_icp)}};
}

Json json_from(const MatchTimes& times) {
  return {{"mrpt_icp_median_ms", times.icp_ms},
          {"paper_median_ms", times.paper_ms},
          {"default_median_ms", times.ours_ms}};
}

}  // namespace setsquare::experiments
