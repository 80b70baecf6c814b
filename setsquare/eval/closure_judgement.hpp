// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "setsquare/core/loop_closure.hpp"
#include "setsquare/eval/pose_pairs.hpp"

namespace setsquare {
/// How far a closure may be from the truth without being wrong.
struct ClosureLimits {
  double max_translation_m = 0.3;
  double max_rotation_rad = rad_from_deg(5.0);
};

/// How far a closure is from the truth.
struct ClosureError {
  double translation_m = 0.0;  ///< Of the position of j seen from i; along the bound axes only.
  double rotation_rad = 0.0;   ///< Wrapped, absolute.

  [[nodiscard]] bool is_within(const ClosureLimits& limits) const {
    return translation_m <= limits.max_translation_m && rotation_rad <= limits.max_rotation_rad;
  }
};

/// The error of a closure whose true pose is `T_i_j`. The axes that a closure binds are the map's:
/// `heading_i_rad`, the heading of i in the map, turns them; it does not matter where both are
/// bound.
[[nodiscard]] ClosureError closure_error(const LoopClosure& closure,
                                         const Pose2& T_i_j,
                                         double heading_i_rad);

enum class ClosureTruth {
  kRight,
  kWrong,
  kBorderline,  ///< Nearer to the limits than the reference's own noise (two sigma).
  kDisputed,    ///< Two independent poses of the reference disagree whether it is right.
  kUnjudged,    ///< No reference reaches it.
};

/// T_i_j by a reference, with one sigma of its position, along either axis, and of its heading.
struct ReferencePose {
  Pose2 T_i_j;
  double translation_sigma_m = 0.0;
  double rotation_sigma_rad = 0.0;
};

struct ClosureJudgement {
  ClosureTruth verdict = ClosureTruth::kUnjudged;
  ClosureError error;  ///< Against the first of the expected poses; 0 where unjudged.
};

/// The pose of stamp_j seen from stamp_i: none, one or several independent ones, the most certain
/// first.
using ReferencePoses = std::function<std::vector<ReferencePose>(Timestamp, Timestamp)>;

/// Right or wrong where one of the expected poses says so by two sigma and none says the contrary;
/// else borderline or disputed. `heading_i_rad` as in closure_error(); where it is missing, a
/// closure of a single axis is unjudged.
[[nodiscard]] ClosureJudgement judge_closure(const LoopClosure& closure,
                                             std::span<const ReferencePose> expected,
                                             std::optional<double> heading_i_rad,
                                             const ClosureLimits& limits = {});

/// Judges each closure. `trajectory` gives the headings in the map that closures of a single axis
/// need; without its heading such a closure stays unjudged.
[[nodiscard]] std::vector<ClosureJudgement> judge_closures(std::span<const LoopClosure> closures,
                                                           const ReferencePoses& expected,
                                                           const PoseIndex& trajectory,
                                                           const ClosureLimits& limits = {});

/// The reference is a trajectory: T_i_j by its poses nearest in time, at most
/// `max_time_difference_s` away.
[[nodiscard]] ReferencePoses expected_from_trajectory(const Trajectory& truth,
                                                      double max_time_difference_s);

/// How many closures were judged how.
struct ClosureCounts {
  std::size_t num_closures = 0;
  std::size_t num_right = 0;
  std::size_t num_wrong = 0;
  std::size_t num_borderline = 0;
  std::size_t num_disputed = 0;
  std::size_t num_unjudged = 0;

  [[nodiscard]] std::size_t num_judged() const { return num_right + num_wrong; }
};

/// Counts one more closure.
void add_verdict(ClosureTruth verdict, ClosureCounts& counts);

struct ClosureSummary {
  ClosureCounts accepted;
  ClosureCounts refused;
  /// Accepted closures that are wrong and still pull: of a weight above kHeavyClosure.
  std::size_t num_heavy_wrong = 0;
};

inline constexpr double kHeavyClosure = 0.3;

/// Counts the judgements of judge_closures(), one per closure, in the same order.
[[nodiscard]] ClosureSummary summarise_closures(std::span<const LoopClosure> closures,
                                                std::span<const ClosureJudgement> judgements);

}  // namespace setsquare
