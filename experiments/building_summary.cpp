// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/building_summary.hpp"

#include <algorithm>
#include <cstdio>

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

std::string text_row(const BuildingSummary& summary, const MatcherSummary& matcher, char mark) {
  char line[240];
  std::snprintf(line,
                sizeof line,
                "%-9s %c %6zu %6zu %7.2f %6zu %7.2f %8.2f %6zu %8.3f %7.4f %7.3f %6.2f %6.1f\n",
                summary.name.c_str(),
                mark,
                matcher.all.num_pairs,
                matcher.high.num_pairs,
                100.0 * matcher.high.success_share(),
                matcher.middle.num_pairs,
                100.0 * matcher.middle.success_share(),
                100.0 * matcher.all.matched_share(),
                matcher.all.num_wrong,
                100.0 * matcher.all.wrong_share(),
                matcher.determined.success_error_m.mean(),
                deg_from_rad(matcher.determined.success_error_rad.mean()),
                matcher.all.right_nees.mean(),
                100.0 * matcher.all.right_nees_inside_share());
  return line;
}

/// The first pairs of a list, one a line.
std::string listing_text(const char* title, const std::vector<ListedPair>& pairs) {
  constexpr std::size_t kMaxLines = 20;
  std::string text = std::string(title) + ": " + std::to_string(pairs.size()) +
                     (pairs.size() > kMaxLines ? ", the first 20:\n" : "\n");
  for (std::size_t i = 0; i < std::min(pairs.size(), kMaxLines); ++i) {
    const PairTruth& truth = pairs[i].record->truth;
    const PairAnswer& answer = pairs[i].record->ours;
    char line[160];
    std::snprintf(line,
                  sizeof line,
                  "  %-9s seed %2llu, %2zu-%2zu: overlap %5.1f %%, %s, off by %.3f m, %.2f deg\n",
                  std::string(to_string(pairs[i].building->building_class)).c_str(),
                  static_cast<unsigned long long>(pairs[i].building->seed),
                  truth.reference,
                  truth.current,
                  100.0 * truth.overlap,
                  std::string(to_string(answer.status)).c_str(),
                  answer.error_m(),
                  deg_from_rad(answer.error_rad()));
    text += line;
  }
  return text;
}

}  // namespace

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

std::string summary_text(const BuildingStudy& study) {
  std::string text =
      "d = default matcher, p = paper; success % of the pairs that the plan determines; "
      "NEES of the right matched\n"
      "class         pairs >=45 %   success 30-45 success matched  wrong % of mtd   err m  err deg "
      "  NEES <7.81\n";
  const std::vector<BuildingSummary> summaries = summarise_by_class(study);
  for (const BuildingSummary& summary : summaries) text += text_row(summary, summary.ours, 'd');
  for (const BuildingSummary& summary : summaries) text += text_row(summary, summary.paper, 'p');
  const BuildingSummary& all = summaries.back();
  char line[200];
  std::snprintf(line,
                sizeof line,
                "%zu buildings; %.1f %% of the pairs below 60 %% overlap; clutter %.1f %% of the "
                "returns; %zu pairs (%.2f %%) of >= 45 %% excluded as undetermined\n",
                all.num_buildings,
                100.0 * share(all.num_below_60, all.num_pairs),
                100.0 * all.clutter_share.mean(),
                all.num_high_undetermined,
                100.0 * share(all.num_high_undetermined, all.num_high));
  const PairLists lists = list_pairs(study);
  return text + line + listing_text("wrong", lists.wrong) +
         listing_text("missed at >= 45 %", lists.failures);
}

}  // namespace setsquare::experiments
