// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from loop_closer, which shows its parameters: the rules, tested without scans.
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <string_view>

#include "setsquare/core/loop_closure.hpp"
#include "setsquare/graph/pose_graph.hpp"
#include "setsquare/mapping/loops/submap_matcher.hpp"
#include "setsquare/mapping/mapper_params.hpp"

namespace setsquare {
enum class ClosureReason {
  kStandsAlone,  ///< Accepted.
  kOneAxis,      ///< Accepted across a corridor, open along it.
  kNoPose,       ///< No pose within the window.
  kLowScore,
  kContradicted,
  kAmbiguous,      ///< Another place explains the submaps almost as well.
  kOpenDirection,  ///< Too few points bind a direction that is not one of the map's axes.
};

/// In lower-case words, for `closures.tsv`.
[[nodiscard]] std::string_view to_string(ClosureReason reason);

[[nodiscard]] inline bool is_accepted(ClosureReason reason) {
  return reason == ClosureReason::kStandsAlone || reason == ClosureReason::kOneAxis;
}

struct ClosureVerdict {
  ClosureReason reason = ClosureReason::kNoPose;
  ClosureAxes axes = ClosureAxes::kXY;  ///< Of the map frame.
};

/// The map's axis that is bound where the direction at this angle in the map is left open.
[[nodiscard]] ClosureAxes axis_across(double open_rad);

/// `reference_heading_rad`: of the reference in the map frame.
[[nodiscard]] ClosureVerdict closure_verdict(const SubmapMatch& match,
                                             double reference_heading_rad,
                                             const ClosureVerdictParams& params = {});

/// Two places that were compared, and what came of it. Poses are those of the sensors.
struct ComparedPlaces {
  std::size_t from = 0;  ///< Keyframe.
  std::size_t to = 0;    ///< Keyframe.
  Pose2 T_from_to;
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< As in Constraint.
  ClosureVerdict verdict;
  double score = 0.0;
  double contradiction = 0.0;
};

/// A match of the submaps about two keyframes, judged. `point_sigma_m`: noise of a point;
/// `from_heading_rad`: of `from` in the map frame. Where one axis stays open the information is
/// zero along it.
[[nodiscard]] ComparedPlaces judged_places(std::size_t from,
                                           std::size_t to,
                                           const SubmapMatch& match,
                                           double from_heading_rad,
                                           double point_sigma_m,
                                           const ClosureVerdictParams& params);

/// A closure of less weight does not establish that two scans see the same place.
inline constexpr double kMinRevisitWeight = 0.5;

/// Places that a match of two scans ties, accepted as it is. `information`: as in Constraint.
[[nodiscard]] ComparedPlaces matched_places(std::size_t from,
                                            std::size_t to,
                                            const Pose2& T_from_to,
                                            const Eigen::Matrix3d& information);

/// The constraint of a pair that was accepted.
[[nodiscard]] Constraint closure_constraint(const ComparedPlaces& places);

}  // namespace setsquare
