// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/closure_judgement.hpp"

#include <cassert>
#include <cmath>
#include <cstdint>

namespace setsquare {
namespace {

constexpr double kSureSigmas = 2.0;

/// The verdict of one expected pose on an error: surely right, surely wrong, or borderline.
ClosureTruth verdict_of(const ClosureError& error,
                        const ReferencePose& expected,
                        const ClosureLimits& limits) {
  const double margin_m = kSureSigmas * expected.translation_sigma_m;
  const double margin_rad = kSureSigmas * expected.rotation_sigma_rad;
  if (error.is_within(
          {limits.max_translation_m - margin_m, limits.max_rotation_rad - margin_rad})) {
    return ClosureTruth::kRight;
  }
  const bool may_be_right =
      error.is_within({limits.max_translation_m + margin_m, limits.max_rotation_rad + margin_rad});
  return may_be_right ? ClosureTruth::kBorderline : ClosureTruth::kWrong;
}

}  // namespace

ClosureError closure_error(const LoopClosure& closure, const Pose2& T_i_j, double heading_i_rad) {
  const Eigen::Vector2d error_i = closure.T_i_j.translation() - T_i_j.translation();
  const Eigen::Vector2d error_map = Pose2{0.0, 0.0, heading_i_rad} * error_i;
  ClosureError error;
  error.rotation_rad = std::abs(wrap_to_pi(closure.T_i_j.theta_rad - T_i_j.theta_rad));
  switch (closure.axes) {
    case ClosureAxes::kXY:
      error.translation_m = error_i.norm();
      break;
    case ClosureAxes::kX:
      error.translation_m = std::abs(error_map.x());
      break;
    case ClosureAxes::kY:
      error.translation_m = std::abs(error_map.y());
      break;
  }
  return error;
}

ClosureJudgement judge_closure(const LoopClosure& closure,
                               std::span<const ReferencePose> expected,
                               std::optional<double> heading_i_rad,
                               const ClosureLimits& limits) {
  const bool has_axis = closure.axes == ClosureAxes::kXY || heading_i_rad;
  if (expected.empty() || !has_axis) return {};
  ClosureJudgement judgement{
      ClosureTruth::kBorderline,
      closure_error(closure, expected.front().T_i_j, heading_i_rad.value_or(0.0))};
  for (const ReferencePose& pose : expected) {
    const ClosureError error = closure_error(closure, pose.T_i_j, heading_i_rad.value_or(0.0));
    const ClosureTruth verdict = verdict_of(error, pose, limits);
    if (verdict == ClosureTruth::kBorderline) continue;
    const bool is_first_to_tell = judgement.verdict == ClosureTruth::kBorderline;
    if (!is_first_to_tell && judgement.verdict != verdict) {
      judgement.verdict = ClosureTruth::kDisputed;
      break;
    }
    judgement.verdict = verdict;
  }
  return judgement;
}

std::vector<ClosureJudgement> judge_closures(std::span<const LoopClosure> closures,
                                             const ReferencePoses& expected,
                                             const PoseIndex& trajectory,
                                             const ClosureLimits& limits) {
  std::vector<ClosureJudgement> judgements;
  for (const LoopClosure& closure : closures) {
    const auto pose_i = trajectory.find(closure.stamp_i);
    judgements.push_back(
        judge_closure(closure,
                      expected(closure.stamp_i, closure.stamp_j),
                      pose_i ? std::optional<double>(pose_i->pose.theta_rad) : std::nullopt,
                      limits));
  }
  return judgements;
}

ReferencePoses expected_from_trajectory(const Trajectory& truth, double max_time_difference_s) {
  const auto tolerance_ns = static_cast<std::int64_t>(std::llround(1e9 * max_time_difference_s));
  return [poses = PoseIndex(truth), tolerance_ns](Timestamp stamp_i,
                                                  Timestamp stamp_j) -> std::vector<ReferencePose> {
    const auto i = poses.find(stamp_i, tolerance_ns);
    const auto j = poses.find(stamp_j, tolerance_ns);
    if (!i || !j) return {};
    return {{i->pose.inverse() * j->pose}};
  };
}

void add_verdict(ClosureTruth verdict, ClosureCounts& counts) {
  ++counts.num_closures;
  switch (verdict) {
    case ClosureTruth::kRight:
      ++counts.num_right;
      break;
    case ClosureTruth::kWrong:
      ++counts.num_wrong;
      break;
    case ClosureTruth::kBorderline:
      ++counts.num_borderline;
      break;
    case ClosureTruth::kDisputed:
      ++counts.num_disputed;
      break;
    case ClosureTruth::kUnjudged:
      ++counts.num_unjudged;
      break;
  }
}

ClosureSummary summarise_closures(std::span<const LoopClosure> closures,
                                  std::span<const ClosureJudgement> judgements) {
  assert(closures.size() == judgements.size());
  ClosureSummary summary;
  for (std::size_t k = 0; k < closures.size(); ++k) {
    const bool is_accepted = closures[k].is_accepted;
    const ClosureTruth verdict = judgements[k].verdict;
    add_verdict(verdict, is_accepted ? summary.accepted : summary.refused);
    const bool is_heavy = closures[k].weight > kHeavyClosure;
    if (is_accepted && is_heavy && verdict == ClosureTruth::kWrong) ++summary.num_heavy_wrong;
  }
  return summary;
}

}  // namespace setsquare
