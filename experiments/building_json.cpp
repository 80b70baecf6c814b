// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/building_report.hpp"
#include "experiments/building_summary.hpp"

namespace setsquare::experiments {
namespace {

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
