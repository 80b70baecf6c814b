// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include "setsquare/eval/closure_judgement.hpp"

#include <cmath>
#include <cstdint>

namespace setsquare {
namespace {

ClosureJudgement judge(const LoopClosure& closure,
                       std::span<const Pose2> expected,
                       std::optional<StampedPose> pose_i,
                       const ClosureLimits& limits) {
  const bool has_axis = closure.axes == ClosureAxes::kXY || pose_i;
  if (expected.empty() || !has_axis) return {};
  const double heading_i_rad = pose_i ? pose_i->pose.theta_rad : 0.0;
  const ClosureError error = closure_error(closure, expected.front(), heading_i_rad);
  const bool is_right = error.is_within(limits);
  for (const Pose2& T_i_j : expected.subspan(1)) {
    if (closure_error(closure, T_i_j, heading_i_rad).is_within(limits) != is_right) {
      return {ClosureVerdict::kDisputed, error};
    }
  }
  return {is_right ? ClosureVerdict::kRight : ClosureVerdict::kWrong, error};
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

std::vector<ClosureJudgement> judge_closures(std::span<const LoopClosure> closures,
                                             const ExpectedPoses& expected,
                                             const PoseIndex& trajectory,
                                             const ClosureLimits& limits) {
  std::vector<ClosureJudgement> judgements;
  for (const LoopClosure& closure : closures) {
    judgements.push_back(judge(closure,
                               expected(closure.stamp_i, closure.stamp_j),
                               trajectory.find(closure.stamp_i),
                               limits));
  }
  return judgements;
}

ExpectedPoses expected_from_trajectory(const Trajectory& truth, double max_time_difference_s) {
  const auto tolerance_ns = static_cast<std::int64_t>(std::llround(1e9 * max_time_difference_s));
  return [poses = PoseIndex(truth), tolerance_ns](Timestamp stamp_i,
                                                  Timestamp stamp_j) -> std::vector<Pose2> {
    const auto i = poses.find(stamp_i, tolerance_ns);
    const auto j = poses.find(stamp_j, tolerance_ns);
    if (!i || !j) return {};
    return {i->pose.inverse() * j->pose};
  };
}

}  // namespace setsquare
