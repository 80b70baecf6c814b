// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "experiments/pairs.hpp"

#include "setsquare/core/symmetric_eigen.hpp"
#include "setsquare/matching/scan_matcher.hpp"
#include "setsquare/paper/paper_matcher.hpp"
#include "setsquare/sim/pairs/pair_geometry.hpp"
#include "setsquare/surfaces/prepared_scan.hpp"

namespace setsquare::experiments {
namespace {

/// Whether the information binds all three of x, y and theta (m and rad taken as equal units).
bool has_full_rank(const Eigen::Matrix3d& information) {
  const Eigen::Vector3d eigenvalues = symmetric_eigenvalues(information);
  return eigenvalues(0) > 1e-9 * eigenvalues(2);
}

PairTruth truth_of_pair(const SimulatedRun& run,
                        std::size_t reference,
                        std::size_t current,
                        const ScannerModel& judge_scanner) {
  const SimulatedScan& first = run.scans[reference];
  const SimulatedScan& second = run.scans[current];
  const PairGeometry geometry =
      pair_geometry(run.caster, judge_scanner, first.T_map_base, second.T_map_base);
  return {.reference = reference,
          .current = current,
          .T_reference_current = true_relative_pose(first, second),
          .overlap = geometry.overlap,
          .is_determined = geometry.is_determined(),
          .worst_direction_rad =
              wrap_to_period(geometry.worst_direction_rad - first.T_map_base.theta_rad, kPi),
          .clutter_share = 0.5 * (first.clutter_share + second.clutter_share)};
}

}  // namespace

Eigen::Vector3d pose_error(const Pose2& answered, const Pose2& truth) {
  return {answered.x_m - truth.x_m,
          answered.y_m - truth.y_m,
          wrap_to_pi(answered.theta_rad - truth.theta_rad)};
}

PairAnswer judge(const MatchResult& result, const Pose2& T_reference_current) {
  PairAnswer answer;
  answer.status = result.status;
  if (!result.T_reference_current) return answer;
  answer.error = pose_error(*result.T_reference_current, T_reference_current);
  if (answer.is_matched() && has_full_rank(result.information)) {
    answer.nees = answer.error.dot(result.information * answer.error);
  }
  return answer;
}

std::vector<PairRecord> match_pairs(const SimulatedRun& run, const PairParams& params) {
  std::vector<PreparedScan> prepared;
  std::vector<PreparedPaperScan> prepared_paper;
  for (const SimulatedScan& simulated : run.scans) {
    prepared.push_back(prepare(simulated.scan));
    if (params.has_paper) prepared_paper.push_back(prepare_paper(simulated.scan));
  }
  std::vector<PairRecord> records;
  std::size_t num_near = 0;
  for (std::size_t i = 0; i < run.scans.size(); ++i) {
    for (std::size_t j = i + 1; j < run.scans.size(); ++j) {
      const Pose2 T_i_j = true_relative_pose(run.scans[i], run.scans[j]);
      if (T_i_j.translation().norm() > params.max_distance_m) continue;
      if (num_near++ % params.every != 0) continue;
      PairRecord record{truth_of_pair(run, i, j, params.judge_scanner), {}, {}};
      record.ours = judge(match(prepared[i], prepared[j]), T_i_j);
      if (params.has_paper) {
        record.paper = judge(match_paper(prepared_paper[i], prepared_paper[j]), T_i_j);
      }
      records.push_back(record);
    }
  }
  return records;
}

}  // namespace setsquare::experiments
