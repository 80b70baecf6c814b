// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/building_study.hpp"

#include <algorithm>

namespace setsquare::experiments {
namespace {

std::size_t overlap_bin(double overlap) {
  return static_cast<std::size_t>(std::clamp(10.0 * overlap, 0.0, 9.0));
}

void add(MatcherSummary& summary, const PairTruth& truth, const PairAnswer& answer) {
  summary.all.add(answer);
  summary.all_by_overlap[overlap_bin(truth.overlap)].add(answer);
  if (!truth.is_determined) return;
  summary.determined.add(answer);
  summary.by_overlap[overlap_bin(truth.overlap)].add(answer);
  if (truth.overlap >= kHighOverlap) {
    summary.high.add(answer);
  } else if (truth.overlap >= kMiddleOverlap) {
    summary.middle.add(answer);
  }
}

void add(BuildingSummary& summary, const BuildingPairs& building) {
  ++summary.num_buildings;
  summary.clutter_share.add(building.clutter_share);
  for (const PairRecord& record : building.pairs) {
    const bool is_high = record.truth.overlap >= kHighOverlap;
    ++summary.num_pairs;
    summary.num_high += is_high;
    summary.num_high_undetermined += is_high && !record.truth.is_determined;
    summary.num_below_60 += record.truth.overlap < 0.6;
    add(summary.ours, record.truth, record.ours);
    add(summary.paper, record.truth, record.paper);
  }
}

Json json_from_bins(const std::array<Tally, 10>& bins) {
  Json json = Json::array();
  for (std::size_t i = 0; i < bins.size(); ++i) {
    json.push_back({{"overlap_from", 0.1 * static_cast<double>(i)}, {"tally", json_from(bins[i])}});
  }
  return json;
}

Json json_from(const MatcherSummary& summary) {
  return {{"all_pairs", experiments::json_from(summary.all)},
          {"determined", experiments::json_from(summary.determined)},
          {"determined_overlap_45_and_more", experiments::json_from(summary.high)},
          {"determined_overlap_30_to_45", experiments::json_from(summary.middle)},
          {"determined_by_overlap", json_from_bins(summary.by_overlap)},
          {"all_by_overlap", json_from_bins(summary.all_by_overlap)}};
}

Json json_from(const BuildingSummary& summary) {
  return {{"class", summary.name},
          {"num_buildings", summary.num_buildings},
          {"num_pairs", summary.num_pairs},
          {"num_overlap_45_and_more", summary.num_high},
          {"num_of_those_undetermined", summary.num_high_undetermined},
          {"share_below_60_overlap", share(summary.num_below_60, summary.num_pairs)},
          {"clutter_share", experiments::json_from(summary.clutter_share)},
          {"default", json_from(summary.ours)},
          {"paper", json_from(summary.paper)}};
}

Json json_from(const std::vector<ListedPair>& pairs) {
  Json json = Json::array();
  for (const ListedPair& pair : pairs) {
    const PairTruth& truth = pair.record->truth;
    Json entry = {{"class", to_string(pair.building->building_class)},
                  {"seed", pair.building->seed},
                  {"reference", truth.reference},
                  {"current", truth.current},
                  {"overlap", truth.overlap},
                  {"is_determined", truth.is_determined},
                  {"clutter_share", truth.clutter_share}};
    entry["answer"] = experiments::json_from(pair.record->ours);
    json.push_back(std::move(entry));
  }
  return json;
}

}  // namespace

BuildingStudy study_buildings(const BuildingStudyParams& params,
                              std::size_t num_threads,
                              const Progress& progress) {
  BuildingStudy study;
  study.buildings.resize(kAllBuildingClasses.size() * params.num_seeds);
  const auto study_one = [&](std::size_t task) {
    BuildingPairs& building = study.buildings[task];
    building.building_class = kAllBuildingClasses[task / params.num_seeds];
    building.seed = 1 + task % params.num_seeds;
    const SimulatedRun run = simulate_study_run(building.building_class, building.seed, params.run);
    building.num_scans = run.scans.size();
    Spread clutter;
    for (const SimulatedScan& simulated : run.scans) clutter.add(simulated.clutter_share);
    building.clutter_share = clutter.mean();
    building.pairs = match_pairs(run, params.pairs);
  };
  run_in_parallel(study.buildings.size(), num_threads, study_one, progress);
  return study;
}

BuildingSummary summarise(const BuildingStudy& study, std::optional<BuildingClass> building_class) {
  BuildingSummary summary;
  summary.name = building_class ? std::string(to_string(*building_class)) : "all";
  for (const BuildingPairs& building : study.buildings) {
    if (!building_class || building.building_class == *building_class) add(summary, building);
  }
  return summary;
}

std::vector<BuildingSummary> summarise_by_class(const BuildingStudy& study) {
  std::vector<BuildingSummary> summaries;
  for (const BuildingClass building_class : kAllBuildingClasses) {
    summaries.push_back(summarise(study, building_class));
  }
  summaries.push_back(summarise(study));
  return summaries;
}

PairLists list_pairs(const BuildingStudy& study) {
  PairLists lists;
  for (const BuildingPairs& building : study.buildings) {
    for (const PairRecord& record : building.pairs) {
      const ListedPair listed{&building, &record};
      const bool is_high = record.truth.overlap >= kHighOverlap;
      if (record.ours.is_wrong()) lists.wrong.push_back(listed);
      if (is_high && !record.truth.is_determined) lists.excluded.push_back(listed);
      if (is_high && record.truth.is_determined && !record.ours.is_success()) {
        lists.failures.push_back(listed);
      }
    }
  }
  return lists;
}

Json json_from(const BuildingStudy& study) {
  Json by_class = Json::array();
  for (const BuildingSummary& summary : summarise_by_class(study)) {
    by_class.push_back(json_from(summary));
  }
  const PairLists lists = list_pairs(study);
  return {{"by_class", by_class},
          {"wrong_matched", json_from(lists.wrong)},
          {"failures_overlap_45_and_more", json_from(lists.failures)},
          {"excluded_as_undetermined", json_from(lists.excluded)}};
}

}  // namespace setsquare::experiments
