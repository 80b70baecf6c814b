// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/honesty_study.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>
#include <limits>

#include "experiments/simulated_run.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/sim/pairs/pair_geometry.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare::experiments {
namespace {

struct JudgedPair {
  MatchResult result;
  PairAnswer answer;
  PairGeometry geometry;
  double worst_direction_rad = 0.0;  ///< In the reference's frame.
};

/// The standard deviation that the information claims along a direction, all else being free:
/// infinite where it claims nothing.
double claimed_sigma_m(const Eigen::Matrix3d& information, double direction_rad) {
  // The direction as the first axis; the two others are taken out by the Schur complement.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  axes.topLeftCorner<2, 2>() << std::cos(direction_rad), -std::sin(direction_rad),
      std::sin(direction_rad), std::cos(direction_rad);
  const Eigen::Matrix3d turned = axes.transpose() * information * axes;
  const Eigen::Matrix2d others = turned.bottomRightCorner<2, 2>();
  const Eigen::FullPivLU<Eigen::Matrix2d> solver(others);
  const Eigen::Vector2d coupling = turned.bottomLeftCorner<2, 1>();
  const double kept = turned(0, 0) - coupling.dot(solver.solve(coupling));
  // What rounding leaves of a direction that is exactly open is no claim.
  const double rounding = 1e-9 * information.topLeftCorner<2, 2>().trace();
  return kept > rounding ? 1.0 / std::sqrt(kept) : std::numeric_limits<double>::infinity();
}

void add_claims(HonestyOutcome& outcome, const JudgedPair& pair) {
  const Eigen::Vector2d along(std::cos(pair.worst_direction_rad),
                              std::sin(pair.worst_direction_rad));
  const Eigen::Vector2d across(-along.y(), along.x());
  const Eigen::Vector2d error_m = pair.answer.error.head<2>();
  const auto add = [&](DirectionClaim& claim, const Eigen::Vector2d& direction) {
    claim.error_m.add(std::abs(direction.dot(error_m)));
    claim.claimed_sigma_m.push_back(
        claimed_sigma_m(pair.result.information, std::atan2(direction.y(), direction.x())));
  };
  add(outcome.along, along);
  add(outcome.across, across);
}

void add(HonestyOutcome& outcome, const JudgedPair& pair) {
  ++outcome.num_pairs;
  outcome.num_determined += pair.geometry.is_determined();
  ++outcome.status_counts[static_cast<std::size_t>(pair.answer.status)];
  outcome.num_wrong += pair.answer.is_wrong();
  if (pair.answer.nees) outcome.nees.add(*pair.answer.nees);
  const bool is_degenerate = pair.answer.status == MatchStatus::kDegenerate;
  if (is_degenerate && pair.result.degenerate_direction_rad && !pair.geometry.is_determined()) {
    outcome.direction_error_rad.add(std::abs(
        wrap_to_period(*pair.result.degenerate_direction_rad - pair.worst_direction_rad, kPi)));
  }
  if (pair.result.T_reference_current && (is_degenerate || pair.answer.is_matched())) {
    add_claims(outcome, pair);
  }
}

std::vector<JudgedPair> judge_world(const HonestyStudyParams& params,
                                    SmallWorld world,
                                    std::uint64_t seed) {
  const Building building = make_small_world(world, seed);
  const RobotPath path(building.route_m);
  std::vector<double> times_s = sample_times(path, 0.5, rad_from_deg(30.0));
  times_s.resize(std::min(times_s.size(), params.num_scans));
  const SimulatedRun run = simulate_run(building, path, times_s, {}, sub_seed(seed, 700));
  std::vector<PreparedScan> prepared;
  for (const SimulatedScan& scan : run.scans) prepared.push_back(prepare(scan.scan));
  std::vector<JudgedPair> pairs;
  for (std::size_t i = 0; i < run.scans.size(); ++i) {
    for (std::size_t j = i + 1; j < run.scans.size(); ++j) {
      const SimulatedScan& reference = run.scans[i];
      const SimulatedScan& current = run.scans[j];
      JudgedPair pair;
      pair.result = match(prepared[i], prepared[j]);
      pair.answer = judge(pair.result, true_relative_pose(reference, current));
      pair.geometry =
          pair_geometry(run.caster, utm_30lx(), reference.T_map_base, current.T_map_base);
      pair.worst_direction_rad = pair.geometry.worst_direction_rad - reference.T_map_base.theta_rad;
      pairs.push_back(pair);
    }
  }
  return pairs;
}

/// Scans of a building of one class matched with scans of the next class' building of that seed.
std::vector<MatchStatus> match_strangers(std::uint64_t seed, std::size_t class_index) {
  const auto& classes = kAllBuildingClasses;
  const SimulatedRun first = simulate_study_run(classes[class_index], seed, {});
  const SimulatedRun second =
      simulate_study_run(classes[(class_index + 1) % classes.size()], seed + 1000, {});
  std::vector<PreparedScan> others;
  for (const SimulatedScan& scan : second.scans) others.push_back(prepare(scan.scan));
  std::vector<MatchStatus> statuses;
  for (std::size_t i = 0; i < first.scans.size(); i += 4) {
    const PreparedScan reference = prepare(first.scans[i].scan);
    for (std::size_t j = 0; j < others.size(); j += 2) {
      statuses.push_back(match(reference, others[j]).status);
    }
  }
  return statuses;
}

HonestyOutcome outcome_of(const SmallWorldWords& words) {
  HonestyOutcome outcome;
  outcome.name = words.name;
  outcome.truth = words.truth;
  return outcome;
}

Json json_from(const DirectionClaim& claim) {
  const auto num_unbounded = std::count_if(
      claim.claimed_sigma_m.begin(), claim.claimed_sigma_m.end(), [](double claimed_m) {
        return !std::isfinite(claimed_m);
      });
  const double sigma_m = median(claim.claimed_sigma_m);
  return {{"error_m", experiments::json_from(claim.error_m)},
          {"num_unbounded", num_unbounded},
          {"median_claimed_sigma_m", std::isfinite(sigma_m) ? Json(sigma_m) : Json(nullptr)}};
}

}  // namespace

HonestyStudy study_honesty(const HonestyStudyParams& params,
                           std::size_t num_threads,
                           const Progress& progress) {
  const std::size_t num_worlds = kAllSmallWorlds.size();
  const std::size_t num_classes = kAllBuildingClasses.size();
  std::vector<std::vector<JudgedPair>> pairs(num_worlds * params.num_seeds);
  std::vector<std::vector<MatchStatus>> strangers(num_classes * params.num_seeds);
  const auto study_one = [&](std::size_t task) {
    if (task < pairs.size()) {
      pairs[task] = judge_world(
          params, kAllSmallWorlds[task / params.num_seeds], 1 + task % params.num_seeds);
      return;
    }
    const std::size_t t = task - pairs.size();
    strangers[t] = match_strangers(1 + t % params.num_seeds, t / params.num_seeds);
  };
  run_in_parallel(pairs.size() + strangers.size(), num_threads, study_one, progress);

  HonestyStudy study;
  study.num_seeds = params.num_seeds;
  for (std::size_t task = 0; task < pairs.size(); ++task) {
    if (task % params.num_seeds == 0) {
      study.outcomes.push_back(outcome_of(words_of(kAllSmallWorlds[task / params.num_seeds])));
    }
    for (const JudgedPair& pair : pairs[task]) add(study.outcomes.back(), pair);
  }
  study.outcomes.push_back(outcome_of({"two different buildings", "nothing in common"}));
  HonestyOutcome& last = study.outcomes.back();
  for (const std::vector<MatchStatus>& statuses : strangers) {
    for (const MatchStatus status : statuses) {
      ++last.num_pairs;
      ++last.status_counts[static_cast<std::size_t>(status)];
      last.num_wrong += status == MatchStatus::kMatched;
    }
  }
  return study;
}

Json json_from(const HonestyStudy& study) {
  Json worlds = Json::array();
  for (const HonestyOutcome& outcome : study.outcomes) {
    Json statuses;
    for (const MatchStatus status : kAnswerStatuses) {
      statuses[std::string(to_string(status))] =
          outcome.status_counts[static_cast<std::size_t>(status)];
    }
    worlds.push_back({{"world", outcome.name},
                      {"what_can_be_known", outcome.truth},
                      {"num_pairs", outcome.num_pairs},
                      {"num_determined", outcome.num_determined},
                      {"statuses", statuses},
                      {"num_wrong_matched", outcome.num_wrong},
                      {"degenerate_direction_error_deg",
                       json_from(outcome.direction_error_rad, deg_from_rad(1.0))},
                      {"nees", json_from(outcome.nees)},
                      {"along_the_worst_direction", json_from(outcome.along)},
                      {"across_it", json_from(outcome.across)}});
  }
  return {{"num_seeds", study.num_seeds}, {"worlds", worlds}};
}

}  // namespace setsquare::experiments
