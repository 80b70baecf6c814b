// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/factor_study.hpp"

namespace setsquare::experiments {
namespace {

/// All buildings, a fifth of their pairs: else a level would take as long as the study itself.
constexpr std::size_t kEvery = 5;

FactorLevel level_with(const std::string& factor,
                       const std::string& level,
                       const ScannerModel& scanner,
                       const ScannerModel& judge_scanner) {
  FactorLevel result;
  result.factor = factor;
  result.level = level;
  result.run.scanner = scanner;
  result.judge_scanner = judge_scanner;
  return result;
}

void add_people(std::vector<FactorLevel>& levels) {
  levels.push_back(level_with("people", "with", utm_30lx(), utm_30lx()));
  levels.push_back(level_with("people", "without", utm_30lx(), utm_30lx()));
  levels.back().run.has_people = false;
}

void add_scanners(std::vector<FactorLevel>& levels) {
  for (const int degrees : {180, 270, 360}) {
    const ScannerModel scanner = with_field_of_view(utm_30lx(), rad_from_deg(degrees));
    levels.push_back(
        level_with("field of view", std::to_string(degrees) + " deg", scanner, scanner));
  }
  for (const std::size_t num_beams : {1081, 541, 271, 136, 68, 34, 17, 11}) {
    levels.push_back(level_with(
        "beams", std::to_string(num_beams), with_num_beams(utm_30lx(), num_beams), utm_30lx()));
  }
  levels.push_back(level_with("scanner", "UTM-30LX", utm_30lx(), utm_30lx()));
  levels.push_back(level_with("scanner", "low cost", low_cost_360(), low_cost_360()));
}

/// A sweep in no time, the usual speed, and one at which the robot moves 4 cm or turns 2 deg while
/// the UTM-30LX sweeps.
void add_motions(std::vector<FactorLevel>& levels) {
  levels.push_back(level_with("motion", "standing", utm_30lx(), utm_30lx()));
  levels.back().run.scanner.sweep_s = 0.0;
  levels.push_back(level_with("motion", "0.5 m/s", utm_30lx(), utm_30lx()));
  levels.push_back(level_with("motion", "1.5 m/s", utm_30lx(), utm_30lx()));
  levels.back().run.speed.drive_m_per_s = 1.5;
  levels.back().run.speed.turn_rad_per_s = 1.5;
}

Json outcome_json(const MatcherSummary& summary) {
  Json success = Json::array();
  Json num_pairs = Json::array();
  for (const Tally& bin : summary.by_overlap) {
    success.push_back(bin.success_share());
    num_pairs.push_back(bin.num_pairs);
  }
  return {{"all_pairs", json_from(summary.all)},
          {"determined", json_from(summary.determined)},
          {"determined_overlap_45_and_more", json_from(summary.high)},
          {"determined_overlap_30_to_45", json_from(summary.middle)},
          {"determined_success_by_tenth_of_overlap", success},
          {"num_determined_by_tenth_of_overlap", num_pairs}};
}

}  // namespace

std::vector<FactorLevel> factor_levels() {
  std::vector<FactorLevel> levels;
  add_people(levels);
  add_scanners(levels);
  add_motions(levels);
  return levels;
}

FactorStudy study_factors(std::size_t num_seeds,
                          std::size_t num_threads,
                          const Progress& progress) {
  FactorStudy study;
  study.num_seeds = num_seeds;
  const std::vector<FactorLevel> levels = factor_levels();
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const FactorLevel& level = levels[i];
    BuildingStudyParams params;
    params.num_seeds = num_seeds;
    params.run = level.run;
    params.pairs.judge_scanner = level.judge_scanner;
    params.pairs.every = kEvery;
    const auto tell = [&](std::size_t num_done, std::size_t num_tasks) {
      if (progress) progress(i * num_tasks + num_done, levels.size() * num_tasks);
    };
    const BuildingStudy buildings = study_buildings(params, num_threads, tell);
    study.outcomes.push_back({level.factor, level.level, summarise(buildings)});
  }
  return study;
}

Json json_from(const FactorStudy& study) {
  Json levels = Json::array();
  for (const FactorOutcome& outcome : study.outcomes) {
    levels.push_back({{"factor", outcome.factor},
                      {"level", outcome.level},
                      {"num_pairs", outcome.summary.num_pairs},
                      {"num_overlap_45_and_more", outcome.summary.num_high},
                      {"num_of_those_undetermined", outcome.summary.num_high_undetermined},
                      {"default", outcome_json(outcome.summary.ours)},
                      {"paper", outcome_json(outcome.summary.paper)}});
  }
  return {{"num_seeds_of_each_class", study.num_seeds}, {"levels", levels}};
}

}  // namespace setsquare::experiments
