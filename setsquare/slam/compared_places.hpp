// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <Eigen/Core>

#include "setsquare/graph/pose_graph.hpp"
#include "setsquare/slam/closure_verdict.hpp"
#include "setsquare/slam/submap_matcher.hpp"

namespace setsquare {

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

/// A match of the submaps about two keyframes, judged. `point_sigma_m`: how much a point tells;
/// `from_heading_rad`: of `from` in the map frame. Where one axis stays open the information says
/// nothing along it.
[[nodiscard]] ComparedPlaces judged_places(std::size_t from,
                                           std::size_t to,
                                           const SubmapMatch& match,
                                           double from_heading_rad,
                                           double point_sigma_m,
                                           const ClosureVerdictParams& params);

/// The constraint of a pair that was accepted.
[[nodiscard]] Constraint closure_constraint(const ComparedPlaces& places);

}  // namespace setsquare
