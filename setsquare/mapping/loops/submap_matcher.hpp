// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Apart from verdict, which shows its answer: loops and piece joining match by it.
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "setsquare/mapping/loops/submap.hpp"
#include "setsquare/mapping/mapper_params.hpp"
#include "setsquare/tracking/open_direction.hpp"
#include "setsquare/tracking/submap_alignment.hpp"

namespace setsquare {

/// One submap placed in the other, compared both ways.
struct SubmapFitBothWays {
  Pose2 T_reference_current;
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();   ///< As in SubmapAlignment, of both ways.
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< Likewise.
  double score = -1.0;         ///< Explained less contradicted, of the points compared; at most 1.
  double contradiction = 0.0;  ///< Contradicted points as a share of those that can be judged.
  /// As the score, but of the points that can be judged: points that are hidden behind the other's
  /// surfaces do not count. Similar places agree equally from every point of view.
  double agreement = -1.0;
};

/// Where a submap lies in another.
struct SubmapMatch {
  SubmapFitBothWays best;
  std::vector<SubmapFitBothWays> others;  ///< Caught elsewhere, the best by score first.
  OpenDirection open;                     ///< In the reference's frame.
};

/// What is known before matching.
struct ExpectedPose {
  Pose2 T_reference_current;
  double window_m = 0.0;  ///< The true position lies this near along each axis.
};

/// Finds the translation under which two submaps agree; the rotation is known from the fused
/// headings but for a fraction of a degree.
///
/// 1. Propose: every translation of the window is correlated at the expected rotation.
/// 2. Refine the best point to line, both ways, the rotation free but held by heading_weight.
/// 3. Score: points explained less points contradicted, both ways.
/// Nothing where no proposal is worth refining or stays within the window.
[[nodiscard]] std::optional<SubmapMatch> match_submaps(const Submap& reference,
                                                       const Submap& current,
                                                       const ExpectedPose& expected,
                                                       const SubmapMatchParams& params = {});

}  // namespace setsquare
