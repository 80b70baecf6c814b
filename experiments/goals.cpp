// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/goals.hpp"

#include <fmt/core.h>

#include <optional>

#include "experiments/text_table.hpp"

namespace setsquare::experiments {
namespace {

Goal success_goal(const std::string& where,
                  const Tally& high,
                  const Tally* middle,
                  std::size_t num_excluded) {
  Goal goal{where + ": right where overlap >= 45 %, of the pairs that the plan determines",
            "all",
            ">= 99 %, at most 5 % excluded",
            middle == nullptr ? "100 %" : "100 %, and >= 95 % at 30-45 %",
            "-"};
  if (high.num_pairs == 0) return goal;
  const double excluded = share(num_excluded, num_excluded + high.num_pairs);
  goal.reached = fmt::format("{}, {} excluded", percent(high.success_share()), percent(excluded));
  if (middle != nullptr) {
    goal.reached += fmt::format("; {} at 30-45 %", percent(middle->success_share()));
  }
  goal.is_known = true;
  goal.meets_must = high.success_share() >= 0.99 && excluded <= 0.05;
  goal.meets_aim =
      high.num_success == high.num_pairs && (middle == nullptr || middle->success_share() >= 0.95);
  return goal;
}

Goal wrong_goal(const std::optional<BuildingSummary>& all) {
  Goal goal{"Buildings: wrong among those answered 'matched', all pairs within 5 m",
            "-",
            "<= 0.1 %",
            "0",
            "-"};
  if (!all) return goal;
  const Tally& tally = all->ours.all;
  goal.reached = fmt::format(
      "{} of {} ({})", tally.num_wrong, tally.num_matched, percent(tally.wrong_share(), 3));
  goal.is_known = true;
  goal.meets_must = tally.wrong_share() <= 0.001;
  goal.meets_aim = tally.num_wrong == 0;
  return goal;
}

Goal error_goal(const std::string& where, const Tally& tally) {
  Goal goal{where + ": mean error of the successes, UTM-30LX",
            "0.04 m, 0.33 deg",
            "<= 0.010 m, 0.10 deg",
            "<= 0.005 m, 0.05 deg",
            "-"};
  if (tally.num_success == 0) return goal;
  const double error_m = tally.success_error_m.mean();
  const double error_deg = deg_from_rad(tally.success_error_rad.mean());
  goal.reached = fmt::format("{:.4f} m, {:.3f} deg", error_m, error_deg);
  goal.is_known = true;
  goal.meets_must = error_m <= 0.010 && error_deg <= 0.10;
  goal.meets_aim = error_m <= 0.005 && error_deg <= 0.05;
  return goal;
}

Goal closure_goal(const std::optional<CircuitStudy>& study) {
  Goal goal{"Large building, scan to scan, default: closure error after 398 m / 901 m, median",
            "0.85 / 1.30 m",
            "<= 0.25 / 0.45 m",
            "<= 0.1 / 0.2 m",
            "-"};
  if (!study) return goal;
  const auto norm_m = closure_medians(*study, &CircuitRun::ours).norm_m;
  goal.reached = fmt::format("{:.3f} / {:.3f} m", norm_m[0], norm_m[1]);
  goal.is_known = true;
  goal.meets_must = norm_m[0] <= 0.25 && norm_m[1] <= 0.45;
  goal.meets_aim = norm_m[0] <= 0.1 && norm_m[1] <= 0.2;
  return goal;
}

Goal mapper_goal(const std::optional<CircuitStudy>& study) {
  Goal goal{
      "Large building, full mapper without odometry, the first pose aligned: error of the last "
      "pose "
      "/ mean error of all poses, median of the seeds (worst)",
      "-",
      "<= 0.15 / 0.10 m",
      "<= 0.05 m",
      "-"};
  if (!study) return goal;
  const MapMedians map = map_medians(*study, &CircuitRun::mapper_errors);
  goal.reached = fmt::format("{:.3f} ({:.3f}) / {:.3f} ({:.3f}) m",
                             map.final_m,
                             map.worst_final_m,
                             map.mean_m,
                             map.worst_mean_m);
  goal.is_known = true;
  goal.meets_must = map.final_m <= 0.15 && map.mean_m <= 0.10;
  goal.meets_aim = map.final_m <= 0.05 && map.mean_m <= 0.05;
  return goal;
}

std::string heading_text(const HeadingJudgement& judgement, std::size_t num_seeds) {
  return fmt::format(
      "{:.3f} deg at the end (median; worst {:.3f}), slope {:.4f} deg per 100 m (median), {} of {} "
      "seeds within 0.5 deg, {} wrong turns",
      judgement.median_end_deg,
      judgement.worst_end_deg,
      judgement.median_slope_deg_per_100_m,
      num_seeds - judgement.failing.size(),
      num_seeds,
      judgement.num_wrong_turns);
}

Goal heading_goal(const std::optional<CircuitStudy>& study) {
  Goal goal{
      "Large building, --preset paper in sequence (the nearest of the four offsets): heading "
      "error along the track; then with the literal choice of the offset",
      "no errors in the direction",
      "no growth with distance, <= 0.5 deg at the end",
      "-",
      "-"};
  if (!study) return goal;
  const std::size_t num_seeds = study->runs.size();
  const HeadingJudgement judgement = judge_headings(*study, &CircuitRun::paper);
  goal.reached = heading_text(judgement, num_seeds);
  for (const CircuitRun* run : judgement.failing) {
    const bool is_first = run == judgement.failing.front();
    goal.reached += fmt::format("{}{}", is_first ? "; not: seeds " : ", ", run->seed);
  }
  goal.reached +=
      "; literal: " + heading_text(judge_headings(*study, &CircuitRun::paper_literal), num_seeds);
  goal.is_known = true;
  // Over the whole track less than half of what is allowed at the end.
  const bool grows = judgement.median_slope_deg_per_100_m * 11.24 > 0.5 * kMaxEndHeading_deg;
  goal.meets_must = judgement.median_end_deg <= kMaxEndHeading_deg && !grows;
  goal.meets_aim = goal.meets_must && judgement.failing.empty();
  return goal;
}

Goal covariance_goal(const std::optional<BuildingSummary>& all) {
  Goal goal{
      "Buildings: e^T Omega e of the right matched pairs with full rank (within 0.2 m and 3 "
      "deg; wrong ones have a row of their own), and the share of all matched, wrong included",
      "-",
      "mean 2-5, 90-98 % below 7.81",
      "mean 2.5-3.5",
      "-"};
  if (!all) return goal;
  const Tally& tally = all->ours.all;
  const double mean = tally.right_nees.mean();
  const double inside = tally.right_nees_inside_share();
  goal.reached = fmt::format("mean {}, {} below 7.81; of all matched {}",
                             number(mean, 2),
                             percent(inside, 1),
                             percent(tally.nees_inside_share(), 1));
  goal.is_known = true;
  goal.meets_must = mean >= 2.0 && mean <= 5.0 && inside >= 0.90 && inside <= 0.98;
  goal.meets_aim = goal.meets_must && mean >= 2.5 && mean <= 3.5;
  return goal;
}

}  // namespace

std::vector<Goal> goals_of(const PaperExperiment& experiment) {
  std::optional<BuildingSummary> buildings;
  if (experiment.buildings) buildings = summarise(*experiment.buildings);
  HallwaySummary hallways;
  if (experiment.hallways) {
    hallways = summarise(*experiment.hallways, experiment.hallways->runs.size());
  }
  const BuildingSummary none;
  const BuildingSummary& shown = buildings ? *buildings : none;
  return {
      success_goal("Hallways", hallways.ours_high, nullptr, hallways.num_high_undetermined),
      success_goal("Buildings", shown.ours.high, &shown.ours.middle, shown.num_high_undetermined),
      wrong_goal(buildings),
      error_goal("Hallways", hallways.ours),
      error_goal("Buildings", shown.ours.determined),
      closure_goal(experiment.circuits),
      heading_goal(experiment.circuits),
      mapper_goal(experiment.circuits),
      covariance_goal(buildings)};
}

Goal time_goal(const PaperExperiment& experiment) {
  Goal goal{"The whole page", "-", "<= 5 min on two cores", "<= 1 min", "-"};
  for (const std::string& name : paper_section_names()) {
    if (!experiment.timing.contains(name + "_s")) return goal;
  }
  const double wall_s = experiment.timing.at("all_s").get<double>();
  goal.reached = fmt::format("{:.0f} s", wall_s);
  goal.is_known = true;
  goal.meets_must = wall_s <= 300.0;
  goal.meets_aim = wall_s <= 60.0;
  return goal;
}

Json json_from(const std::vector<Goal>& goals) {
  Json json = Json::array();
  for (const Goal& goal : goals) {
    json.push_back({{"what", goal.what},
                    {"paper", goal.paper},
                    {"must", goal.must},
                    {"aim", goal.aim},
                    {"reached", goal.reached}});
    if (!goal.is_known) continue;
    json.back()["meets_must"] = goal.meets_must;
    json.back()["meets_aim"] = goal.meets_aim;
  }
  return json;
}

}  // namespace setsquare::experiments
