// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/goals.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/building_summary.hpp"
#include "experiments/page_elements.hpp"
#include "setsquare/drawing/text.hpp"

namespace setsquare::experiments {
namespace {

Goal success_goal(const std::string& where,
                  const Tally& high,
                  const Tally* middle,
                  std::size_t num_excluded) {
  Goal goal{joined({where, ": right where overlap >= 45 %, of the pairs that the plan determines"}),
            "all",
            ">= 99 %, at most 5 % excluded",
            middle == nullptr ? "100 %" : "100 %, and >= 95 % at 30-45 %",
            "-"};
  if (high.num_pairs == 0) return goal;
  const double excluded = share(num_excluded, num_excluded + high.num_pairs);
  goal.reached = joined({percent(high.success_share()), ", ", percent(excluded), " excluded"});
  if (middle != nullptr) {
    goal.reached += joined({"; ", percent(middle->success_share()), " at 30-45 %"});
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
  goal.reached = joined({number(tally.num_wrong),
                         " of ",
                         number(tally.num_matched),
                         " (",
                         percent(tally.wrong_share(), 3),
                         ")"});
  goal.is_known = true;
  goal.meets_must = tally.wrong_share() <= 0.001;
  goal.meets_aim = tally.num_wrong == 0;
  return goal;
}

Goal error_goal(const std::string& where, const Tally& tally) {
  Goal goal{joined({where, ": mean error of the successes, UTM-30LX"}),
            "0.04 m, 0.33 deg",
            "<= 0.010 m, 0.10 deg",
            "<= 0.005 m, 0.05 deg",
            "-"};
  if (tally.num_success == 0) return goal;
  const double error_m = tally.success_error_m.mean();
  const double error_deg = deg_from_rad(tally.success_error_rad.mean());
  goal.reached = joined({number(error_m, 4), " m, ", number(error_deg, 3), " deg"});
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
  goal.reached = joined({number(norm_m[0], 3), " / ", number(norm_m[1], 3), " m"});
  goal.is_known = true;
  goal.meets_must = norm_m[0] <= 0.25 && norm_m[1] <= 0.45;
  goal.meets_aim = norm_m[0] <= 0.1 && norm_m[1] <= 0.2;
  return goal;
}

Goal heading_goal(const std::optional<CircuitStudy>& study) {
  Goal goal{"Large building, --preset paper: heading error along the track",
            "no errors in the direction",
            "no growth with distance, <= 0.5 deg at the end",
            "-",
            "-"};
  if (!study) return goal;
  double worst_end_rad = 0.0;
  double worst_square_rad = 0.0;
  std::size_t num_wrong_turns = 0;
  std::vector<double> slopes;
  for (const CircuitRun& run : study->runs) {
    const HeadingErrors& heading = run.paper.heading;
    worst_end_rad = std::max(worst_end_rad, heading.end_rad);
    worst_square_rad = std::max(worst_square_rad, heading.square_end_rad);
    num_wrong_turns += heading.num_wrong_turns;
    slopes.push_back(deg_from_rad(std::abs(heading.square_slope_rad_per_100_m)));
  }
  const double slope_deg = median(slopes);
  goal.reached = joined({number(deg_from_rad(worst_end_rad), 3),
                         " deg at the end (worst seed; modulo 90 deg: ",
                         number(deg_from_rad(worst_square_rad), 3),
                         "), slope modulo 90 deg ",
                         number(slope_deg, 4),
                         " deg per 100 m (median), ",
                         number(num_wrong_turns),
                         " wrong turns over ",
                         number(study->runs.size()),
                         " seeds"});
  goal.is_known = true;
  // Over the whole track less than half of what is allowed at the end.
  const bool grows = slope_deg * 11.24 > 0.25 || num_wrong_turns > 0;
  goal.meets_must = deg_from_rad(worst_end_rad) <= 0.5 && !grows;
  goal.meets_aim = goal.meets_must;
  return goal;
}

Goal covariance_goal(const std::optional<BuildingSummary>& all) {
  Goal goal{"Buildings: e^T Omega e of the matched pairs with full rank",
            "-",
            "mean 2-5, 90-98 % below 7.81",
            "mean 2.5-3.5",
            "-"};
  if (!all) return goal;
  const double mean = all->ours.all.nees.mean();
  const double inside = all->ours.all.nees_inside_share();
  goal.reached = joined({"mean ", number(mean, 2), ", ", percent(inside, 1), " below 7.81"});
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
      covariance_goal(buildings)};
}

Goal time_goal(const PaperExperiment& experiment) {
  Goal goal{"The whole page", "-", "<= 5 min on two cores", "<= 1 min", "-"};
  for (const std::string& name : paper_section_names()) {
    if (!experiment.timing.contains(name + "_s")) return goal;
  }
  const double wall_s = experiment.timing.at("all_s").get<double>();
  goal.reached = number(wall_s, 0) + " s";
  goal.is_known = true;
  goal.meets_must = wall_s <= 300.0;
  goal.meets_aim = wall_s <= 60.0;
  return goal;
}

}  // namespace setsquare::experiments
