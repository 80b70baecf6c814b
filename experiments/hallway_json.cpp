// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/hallway_report.hpp"

namespace setsquare::experiments {
namespace {

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
